using System;
using System.CommandLine;
using LaserTracking.Host.Scoring;

namespace LaserTracking.Host.Commands
{
    /// <summary>range score: compares events with hand-verified truth.</summary>
    internal static class ScoreCommand
    {
        public static Command Create()
        {
            var events = new Argument<string>("EVENTS.jsonl") { Description = "What 'replay' or 'demo' wrote." };
            var truth = new Argument<string>("TRUTH.json") { Description = "What was really fired." };
            var clip = new Option<string?>("--clip") { HelpName = "NAME", Description = "Which of the truth file's clips; by default the one that the events name as their input." };
            var command = new Command("score", "Compares events with truth; prints JSON.") { events, truth, clip };
            command.SetAction(parsed =>
            {
                Console.WriteLine(EventScorer.Score(parsed.GetValue(events)!, parsed.GetValue(truth)!, parsed.GetValue(clip)));
                return ExitCodes.Done;
            });
            return command;
        }
    }
}
