using System;
using System.IO;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;

namespace LaserTracking.Host.Sources
{
    /// <summary>Opens whatever a user names as input, judged by its content and not by its name.</summary>
    public static class FrameSources
    {
        /// <summary>What kind of input this is.</summary>
        /// <exception cref="InputException">It does not exist, is empty or cannot be read.</exception>
        public static FrameSourceKind Detect(string path)
        {
            if (Directory.Exists(path))
                return FrameSourceKind.ImageFolder;
            if (!File.Exists(path))
                throw new InputException(path.Length == 0 ? "\"\"" : path, "does not exist", "check the path");
            try
            {
                using FileStream file = File.OpenRead(path);
                if (file.Length == 0)
                    throw new InputException(path, "is empty (0 bytes)", "record or copy it again");
                Span<byte> head = stackalloc byte[4];
                bool isMatroska = file.ReadAtLeast(head, 4, throwOnEndOfStream: false) == 4 && head.SequenceEqual(EbmlHead);
                return isMatroska && MentionsAzureKinect(file) ? FrameSourceKind.AzureKinectRecording : FrameSourceKind.Video;
            }
            catch (Exception exception) when (exception is IOException or UnauthorizedAccessException)
            {
                throw new InputException(path, "cannot be read (" + exception.Message.ReplaceLineEndings(" ") + ")", "check its permissions");
            }
        }

        /// <summary>Camera 0: colour, and infrared where there is some; from a recording, a video or a folder of pictures.</summary>
        /// <exception cref="InputException">The input cannot be used at all.</exception>
        public static IFrameSource OpenScreenCamera(string path)
        {
            switch (Detect(path))
            {
                case FrameSourceKind.ImageFolder:
                    return new ImageFolderSource(path);
                case FrameSourceKind.AzureKinectRecording:
                    return new KinectRecordingSource(KinectRecording.Open(path), KinectStreams.Color | KinectStreams.Infrared);
                default:
                    return new VideoSource(path);
            }
        }

        /// <summary>What a projector showed: a video or a folder of pictures, not larger than there is use for.</summary>
        /// <exception cref="InputException">The input cannot be used at all.</exception>
        public static IFrameSource OpenPictures(string path) => Detect(path) switch
        {
            FrameSourceKind.ImageFolder => new ImageFolderSource(path),
            FrameSourceKind.AzureKinectRecording => throw new InputException(path, "this is a camera's recording, not what the projector showed", "give a video of the rendered frames"),
            _ => new VideoSource(path, Detection.RenderedFrameHistory.MaxWidthPx),
        };

        /// <summary>Camera 1: the depth of a recording.</summary>
        /// <param name="path">The recording.</param>
        /// <param name="withInfrared">Its infrared too, where it has some: of the same pixels as depth, for the hand model.</param>
        /// <exception cref="InputException">It holds no depth, or cannot be used at all.</exception>
        public static IFrameSource OpenHandCamera(string path, bool withInfrared = false)
        {
            if (Detect(path) != FrameSourceKind.AzureKinectRecording)
                throw NoDepth(path);
            KinectRecording recording = KinectRecording.Open(path);
            if (recording.DepthTrack != null)
                return new KinectRecordingSource(recording, withInfrared ? KinectStreams.Depth | KinectStreams.Infrared : KinectStreams.Depth);
            recording.Dispose();
            throw NoDepth(path);
        }

        private static InputException NoDepth(string path) =>
            new(path, "the second camera's recording holds no depth", "give the recording of the depth camera that sees the trainees");

        private static ReadOnlySpan<byte> EbmlHead => [0x1A, 0x45, 0xDF, 0xA3];

        /// <summary>
        /// Its own recorder names itself in the head ("k4arecord…"), and every recording has tags that begin with "K4A_", also after
        /// other programs have copied it. They lie in front of the clusters, or at the file's end when another program moved them.
        /// </summary>
        private static bool MentionsAzureKinect(FileStream file)
        {
            const int span = 256 * 1024;
            byte[] buffer = new byte[(int)Math.Min(span, file.Length)];
            foreach (long position in new[] { 0, file.Length - buffer.Length })
            {
                file.Position = position;
                ReadOnlySpan<byte> bytes = buffer.AsSpan(0, file.ReadAtLeast(buffer, buffer.Length, throwOnEndOfStream: false));
                if (bytes.IndexOf("k4arecord"u8) >= 0 || bytes.IndexOf("K4A_"u8) >= 0)
                    return true;
            }

            return false;
        }
    }
}
