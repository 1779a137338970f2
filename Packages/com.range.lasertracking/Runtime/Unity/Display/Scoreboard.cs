using System;
using System.Collections.Generic;
using LaserTracking.Session;
using UnityEngine;
using UnityEngine.UIElements;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Shows the score on the screen: the total, the last shot with its interval, a line for each shooter. Without an emitter it listens
    /// to the one on its own object or above. Texts are written when a shot comes, not in every frame.
    /// </summary>
    [DisallowMultipleComponent]
    [RequireComponent(typeof(UIDocument))]
    [AddComponentMenu("Laser Tracking/Scoreboard")]
    public sealed class Scoreboard : MonoBehaviour
    {
        private static readonly Color Background = new Color(0.06f, 0.08f, 0.1f, 0.75f);

        [SerializeField]
        [Tooltip("Whose shots count. Empty: the LaserRange or RemoteInput on this object or above.")]
        private ShotEmitter? _emitter;

        [SerializeField]
        [Range(8, 72)]
        [Tooltip("Height of a line of text, pixels.")]
        private int _textPx = 22;

        [SerializeField]
        private ShooterColors _colors = new ShooterColors();

        private readonly List<Label> _rows = new List<Label>();
        private ShotEmitter? _listened;
        private VisualElement? _box;
        private Label? _total;
        private Label? _last;

        /// <summary>What is shown.</summary>
        public ScoreSheet Sheet { get; } = new ScoreSheet();

        /// <summary>Begins anew.</summary>
        public void Clear()
        {
            Sheet.Clear();
            Write();
        }

        private void OnEnable()
        {
            VisualElement? root = GetComponent<UIDocument>().rootVisualElement;
            _listened = _emitter != null ? _emitter : GetComponentInParent<ShotEmitter>();
            if (root == null)
                ShotEmitters.Report(this, "Scoreboard " + name + " cannot be seen: its UIDocument has no panel settings; drag RangePanel in", false);
            else
                Build(root);
            if (_listened == null)
                ShotEmitters.Report(this, "Scoreboard " + name + " has no emitter, so it counts nothing; drag the LaserRange in", false);
            else
                _listened.ShotFired += Count;
        }

        private void OnDisable()
        {
            if (_listened is ShotEmitter listened)
                listened.ShotFired -= Count;
            _listened = null;
            _box?.RemoveFromHierarchy();
            _box = null;
            _rows.Clear();
        }

        private void Build(VisualElement root)
        {
            _box = PanelElements.Box(root, "scoreboard", Background, _textPx * 0.6f);
            _box.style.position = Position.Absolute;
            _box.style.left = _box.style.top = _textPx;
            _total = PanelElements.Text(_box, _textPx * 1.6f, Color.white);
            _last = PanelElements.Text(_box, _textPx, Color.white);
            Write();
        }

        private void Count(ShotEvent shot)
        {
            Sheet.Add(shot);
            Write();
        }

        private void Write()
        {
            if (_box == null)
                return;
            ReportTotals total = Sheet.Total;
            _total!.text = FormattableString.Invariant($"{total.Score:0.#}");
            _last!.text = total.Shots == 0 ? "no shot yet" : LastText();
            for (int i = 0; i < Sheet.Shooters.Count; i++)
            {
                if (i == _rows.Count)
                    _rows.Add(PanelElements.Text(_box, _textPx, Color.white));
                ReportTotals row = Sheet.Shooters[i];
                _rows[i].text = RowText(row);
                _rows[i].style.color = _colors.Of(row.Number);
                _rows[i].style.display = DisplayStyle.Flex;
            }

            for (int i = Sheet.Shooters.Count; i < _rows.Count; i++)
                _rows[i].style.display = DisplayStyle.None;
        }

        private string LastText()
        {
            ShotEvent shot = Sheet.Last;
            string hit = shot.HasHit ? FormattableString.Invariant($"{shot.Hit.Target} {shot.Hit.Zone}: {shot.Hit.Score:0.#}") : "miss";
            return double.IsNaN(Sheet.LastIntervalS) ? hit : hit + FormattableString.Invariant($", {Sheet.LastIntervalS:0.00} s after the last");
        }

        private static string RowText(ReportTotals row)
        {
            string text = FormattableString.Invariant($"{row.Name}: {row.Score:0.#}, {row.Hits} of {row.Shots} hit");
            if (row.Mistakes > 0)
                text += FormattableString.Invariant($", {row.Mistakes} wrong");
            return row.Splits == 0 ? text : text + FormattableString.Invariant($", splits {row.MeanSplitS:0.00} s, best {row.BestSplitS:0.00} s");
        }
    }
}
