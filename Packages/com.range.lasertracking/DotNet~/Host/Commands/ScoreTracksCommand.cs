using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Tracks;

namespace LaserTracking.Host.Commands
{
    /// <summary>range score-tracks: CLEAR MOT and identity metrics.</summary>
    internal static class ScoreTracksCommand
    {
        public static Command Create()
        {
            var truth = new Argument<string>("GT.txt") { Description = "The true boxes as MOT15 text: frame,id,x,y,w,h,flag; lines with flag 0 do not count." };
            var tracks = new Argument<string>("TRACKS.txt") { Description = "What a tracker made: frame,id,x,y,w,h." };
            var match = new Option<string>("--match") { HelpName = "HOW", Description = "'centre20': centres at most 20 px apart; 'iou0.5': overlap at least 0.5.", DefaultValueFactory = _ => "centre20" };
            match.AcceptOnlyFromAmong("centre20", "iou0.5");
            var frames = new Option<int?>("--frames") { HelpName = "N", Description = "Length of the sequence, printed as num_frames; by default the last frame that holds a box." };
            var command = new Command("score-tracks", "Compares tracks with the truth: CLEAR MOT and identity metrics as JSON.") { truth, tracks, match, frames };
            command.SetAction(parsed =>
            {
                string path = parsed.GetValue(truth)!;
                List<MotRow> objects = MotFile.ReadTracks(path, mayBeEmpty: false).Where(row => row.Score != 0).ToList();
                if (objects.Count == 0)
                    throw new InputException(path, "every line has flag 0: nothing counts", "set the seventh field of what counts to 1");
                List<MotRow> found = MotFile.ReadTracks(parsed.GetValue(tracks)!, mayBeEmpty: true);
                int last = Math.Max(objects[^1].Frame, found.Count == 0 ? 0 : found[^1].Frame), length = parsed.GetValue(frames) ?? last;
                if (length < last)
                    throw new InputException(frames.Name, FormattableString.Invariant($"{length} is less than {last}, the last frame"), "give the length of the sequence");
                Console.Write(TrackEvaluator.Evaluate(objects, found, parsed.GetValue(match) == "iou0.5" ? TrackMatch.Iou05 : TrackMatch.Centre20, length).ToJson());
                return ExitCodes.Done;
            });
            return command;
        }
    }
}
