using System.CommandLine;
using System.Linq;

namespace LaserTracking.Host.Commands
{
    /// <summary>range help [COMMAND].</summary>
    internal static class HelpCommand
    {
        public static Command Create(RootCommand root)
        {
            var name = new Argument<string?>("COMMAND") { Description = "The command to explain.", Arity = ArgumentArity.ZeroOrOne };
            var command = new Command("help", "Explains everything, or one command.") { name };
            command.SetAction(parsed =>
            {
                string? wanted = parsed.GetValue(name);
                if (wanted != null && root.Subcommands.All(c => c.Name != wanted))
                    throw new InputException(wanted, "there is no such command", "'./range help' lists them");
                string[] line = wanted == null ? new[] { "--help" } : new[] { wanted, "--help" };
                return root.Parse(line).Invoke();
            });
            return command;
        }
    }
}
