using System;
using System.CommandLine;
using System.Linq;

namespace LaserTracking.Host.Commands
{
    /// <summary>range help [COMMAND [COMMAND]].</summary>
    internal static class HelpCommand
    {
        public static Command Create(RootCommand root)
        {
            var names = new Argument<string[]>("COMMAND") { Description = "The command to explain: replay, or calibrate screen.", Arity = ArgumentArity.ZeroOrMore };
            var command = new Command("help", "Explains everything, or one command.") { names };
            command.SetAction(parsed =>
            {
                string[] wanted = parsed.GetValue(names) ?? Array.Empty<string>();
                Command at = root;
                foreach (string name in wanted)
                    at = at.Subcommands.FirstOrDefault(c => c.Name == name) ?? throw new InputException(string.Join(' ', wanted), "there is no such command", "'./range help' lists them");
                return root.Parse(wanted.Append("--help").ToArray()).Invoke();
            });
            return command;
        }
    }
}
