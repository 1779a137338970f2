using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using LaserTracking.Capture.Matroska;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// Writes a recording anew, block by block as stored: all tracks, tags and attachments, times to the microsecond. What a recorder
    /// that was killed left behind becomes a whole file that other programs open; what is damaged is left out.
    /// </summary>
    public static class KinectRecordingCopier
    {
        /// <param name="source">Read through its own cursors; where it stands does not matter.</param>
        /// <param name="target">Writable and seekable, empty; stays the caller's.</param>
        /// <param name="progress">Called with the share that is done, 0 to 1; null: nobody.</param>
        /// <param name="interrupted">Ends it early: what is copied so far is a whole file.</param>
        /// <returns>Blocks written.</returns>
        /// <exception cref="IOException">The target refuses.</exception>
        public static long Copy(KinectRecording source, Stream target, Action<double>? progress = null, CancellationToken interrupted = default)
        {
            MatroskaFile file = source.File;
            MatroskaHead head = HeadOf(source);
            var known = new HashSet<long>();
            foreach (MatroskaTrack track in head.Tracks)
                known.Add(track.Number);
            var writer = new MatroskaWriter(target, head);
            BlockCursor cursor = file.CreateCursor(BlockParser.AnyTrack);
            long blocks = 0;
            for (; cursor.TryPeekNext(out MatroskaBlock block) && !interrupted.IsCancellationRequested; cursor.MoveNext())
            {
                // Of what a cut file ends with, and of tracks that nobody described, nothing can be used.
                if (!known.Contains(block.Track) || block.TimeNs < 0 || block.PayloadOffset + block.PayloadSize > file.Reader.Length)
                    continue;
                Span<byte> payload = writer.AddBlock(block.Track, block.TimeNs / 1000, block.PayloadSize, block.Lacing, block.DurationNs / 1000);
                if (!file.Reader.TryRead(block.PayloadOffset, payload))
                    throw new InputException(source.Name, "cannot be read at byte " + block.PayloadOffset, "copy it from where it was recorded");
                blocks++;
                if (progress != null && source.LengthUs > 0)
                    progress(Math.Min(1, block.TimeNs / 1000.0 / source.LengthUs));
            }

            writer.Finish();
            return blocks;
        }

        private static MatroskaHead HeadOf(KinectRecording source)
        {
            var head = new MatroskaHead();
            foreach (MatroskaTrack track in source.File.Tracks)
            {
                if (track.Number > 0)
                    head.Tracks.Add(track);
            }

            head.Tags.AddRange(source.Tags);
            foreach (MatroskaAttachment attachment in source.Attachments)
            {
                if (source.TryReadAttachment(attachment, out byte[] content))
                    head.Attachments.Add((attachment, content));
            }

            return head;
        }
    }
}
