using System;
using System.IO;
using System.Text;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Simulation
{
    /// <summary>Scenarios as JSON. Fields that are absent keep their defaults; unknown fields and values out of range are refused.</summary>
    public static class SimulationScenarioFile
    {
        /// <exception cref="InputException">Not there, not JSON, an unknown field, a value of the wrong kind or out of range.</exception>
        public static SimulationScenario Read(string path)
        {
            if (Directory.Exists(path))
                throw new InputException(path, "is a folder", "give a scenario file");
            string json;
            try
            {
                json = File.ReadAllText(path, Encoding.UTF8);
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException || e is ArgumentException || e is NotSupportedException)
            {
                throw new InputException(path, File.Exists(path) ? "cannot be read" : "no such file", "give the path of a scenario file");
            }

            return Parse(json, path);
        }

        /// <param name="json">The file's text.</param>
        /// <param name="source">How messages name it.</param>
        /// <exception cref="InputException">As for <see cref="Read"/>.</exception>
        public static SimulationScenario Parse(string json, string source)
        {
            JObject root;
            try
            {
                using var reader = new JsonTextReader(new StringReader(json)) { MaxDepth = 32, DateParseHandling = DateParseHandling.None };
                root = JObject.Load(reader, new JsonLoadSettings
                {
                    LineInfoHandling = LineInfoHandling.Load,
                    DuplicatePropertyNameHandling = DuplicatePropertyNameHandling.Error,
                });
                // Reads on only to find out that nothing follows; the reader complains when something does.
                while (reader.Read())
                {
                }
            }
            catch (JsonReaderException e)
            {
                throw new InputException(source, "line " + e.LineNumber + ": is not valid JSON", "correct it, commas and brackets first");
            }
            catch (JsonException)
            {
                throw new InputException(source, "is not one JSON object with each field once", "remove what is there twice");
            }

            var scenario = new SimulationScenario();
            var settings = new ScenarioReader(source, root);
            scenario.Visit(settings);
            settings.RefuseUnknownFields();
            return scenario;
        }

        /// <summary>The scenario with all its settings, indented, LF line ends.</summary>
        public static string ToJson(SimulationScenario scenario)
        {
            var root = new JObject();
            scenario.Visit(new ScenarioWriter(root));
            return root.ToString(Formatting.Indented).Replace("\r\n", "\n") + "\n";
        }
    }
}
