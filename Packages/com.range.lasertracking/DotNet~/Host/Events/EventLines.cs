using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using System.Text.Json;

namespace LaserTracking.Host.Events
{
    /// <summary>Reads the lines of events.jsonl one by one; whatever cannot be read names file and line.</summary>
    internal static class EventLines
    {
        /// <summary>Every line that is not blank, as a JSON object. The element lives until the next line is asked for.</summary>
        /// <exception cref="InputException">No such file, not UTF-8, or a line that is no JSON object.</exception>
        public static IEnumerable<EventLine> Read(string path)
        {
            using StreamReader reader = Open(path);
            for (int number = 1; ; number++)
            {
                string? text = ReadLine(reader, path, number);
                if (text == null)
                    yield break;
                if (string.IsNullOrWhiteSpace(text))
                    continue;
                using JsonDocument document = Parse(path, number, text);
                if (document.RootElement.ValueKind != JsonValueKind.Object)
                    throw new InputException(path, "line " + number + " is no JSON object", "give a file that ./range replay --events wrote");
                yield return new EventLine(path, number, document.RootElement);
            }
        }

        private static StreamReader Open(string path)
        {
            if (Directory.Exists(path))
                throw new InputException(path, "is a folder", "name a file of events");
            try
            {
                return new StreamReader(path, new UTF8Encoding(false, true));
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
            {
                throw new InputException(path, File.Exists(path) ? "cannot be opened" : "is not there", "check its name and rights");
            }
        }

        private static string? ReadLine(StreamReader reader, string path, int number)
        {
            try
            {
                return reader.ReadLine();
            }
            catch (DecoderFallbackException)
            {
                throw new InputException(path, "line " + number + " or one soon after is not UTF-8", "give a file that ./range replay --events wrote");
            }
            catch (IOException)
            {
                throw new InputException(path, "line " + number + " cannot be read", "check the disk");
            }
        }

        private static JsonDocument Parse(string path, int number, string text)
        {
            try
            {
                return JsonDocument.Parse(text);
            }
            catch (JsonException e)
            {
                throw new InputException(path, "line " + number + " is no JSON, at character " + ((e.BytePositionInLine ?? 0) + 1),
                    "give a file that ./range replay --events wrote");
            }
        }
    }
}
