namespace LaserTracking.Session
{
    /// <summary>
    /// The report's script: whatever stands for a shot lights up together when one of them is pointed at or chosen. Without it the
    /// links between holes and rows still work. No ampersand or angle bracket: the page is XML too.
    /// </summary>
    internal static class ReportScript
    {
        public const string JavaScript =
            "(function(){'use strict';var chosen=null;\n" +
            "function mark(id,on){if(id===null){return;}var all=document.querySelectorAll('[data-shot=\"'+id+'\"]');Array.prototype.forEach.call(all,function(e){e.classList.toggle('on',on);});}\n" +
            "function idOf(node){var e=node.closest?node.closest('[data-shot]'):null;return e?e.getAttribute('data-shot'):null;}\n" +
            "function choose(id){mark(chosen,false);chosen=id===chosen?null:id;mark(chosen,true);}\n" +
            "document.addEventListener('mouseover',function(e){mark(idOf(e.target),true);});\n" +
            "document.addEventListener('mouseout',function(e){var id=idOf(e.target);if(id!==chosen){mark(id,false);}});\n" +
            "document.addEventListener('focusin',function(e){mark(idOf(e.target),true);});\n" +
            "document.addEventListener('focusout',function(e){var id=idOf(e.target);if(id!==chosen){mark(id,false);}});\n" +
            "document.addEventListener('click',function(e){var id=idOf(e.target);if(id===null){return;}var link=e.target.closest('a');if(link){if(e.target.closest('svg')){e.preventDefault();}else if(id===chosen){return;}}choose(id);});\n" +
            "document.addEventListener('keydown',function(e){if(e.key==='Escape'){choose(chosen);}});\n" +
            "})();\n";
    }
}
