using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Calibration;
using LaserTracking.Geometry;
using LaserTracking.Host.Sources;
using LaserTracking.Patterns;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Calibration
{
    /// <summary>
    /// Corners found earlier: {"object_points":[[x,y,z],…] (or object_points_mm), "image_size":[w,h]} with either
    /// "images":[{"image":name,"px":[[x,y],…],"ids":[…]}] or "pairs":[{"left":name,"left_px":[…],"right":name,"right_px":[…]}]. ids, where
    /// given, say which of the board's points each one is; without, all of them in order.
    /// </summary>
    internal sealed class StoredCorners
    {
        private const string Remedy = "correct the file";

        // Where nothing says how large the pictures were.
        private static readonly (int Width, int Height)[] UsualSizes =
            { (640, 480), (640, 576), (1024, 1024), (1280, 720), (1280, 960), (1920, 1080), (2048, 1536), (2560, 1440), (3840, 2160), (4096, 3072) };

        private readonly string _path;
        private readonly JObject _root;
        private readonly Vector2D[] _boardMm;

        private StoredCorners(string path, JObject root, Vector2D[] boardMm, Board? board)
        {
            _path = path;
            _root = root;
            _boardMm = boardMm;
            Board = board;
        }

        /// <summary>Null when the points are no whole grid.</summary>
        public Board? Board { get; }

        /// <summary>What had to be guessed, one line each.</summary>
        public List<string> Notes { get; } = new();

        public bool HasPairs => _root["pairs"] is JArray;

        /// <param name="path">The file.</param>
        /// <param name="size">Must agree with the file where both say it.</param>
        /// <param name="squareMm">Null: the file's own scale, or that of the published board.</param>
        /// <param name="usual">Used when neither says it.</param>
        public static StoredCorners Open(string path, BoardSize? size, double? squareMm, Board usual)
        {
            JObject root = CalibrationJson.ReadFile(path);
            CalibrationJson.CheckVersion(root, path);
            if (root["pairs"] is not JArray { Count: > 0 } && root["images"] is not JArray { Count: > 0 })
                throw new InputException(path, "holds neither images nor pairs", "give \"images\":[{\"image\":…,\"px\":[[x,y],…]}] or \"pairs\":[{\"left_px\":…,\"right_px\":…}]");
            JToken? given = root["object_points_mm"] ?? root["object_points"];
            if (given == null || given.Type == JTokenType.Null)
            {
                var board = new Board(size ?? usual.Size, squareMm ?? usual.SquareMm);
                return new StoredCorners(path, root, board.CornersMm(), board);
            }

            Vector2D[] points = Points(given, path, "object_points");
            (BoardSize Size, double Step)? grid = GridOf(points);
            if (size is BoardSize asked && (grid is { } found ? !found.Size.Equals(asked) : points.Length != asked.Count))
                throw new InputException(path, grid is { } other ? $"its board has {other.Size} corners, {asked} asked for" : $"its board has {points.Length} corners, {asked} asked for", "give the board's own size with --board, or leave it out");
            if (squareMm is double side && grid is { } scaled)
                points = points.Select(point => point * (side / scaled.Step)).ToArray();
            return new StoredCorners(path, root, points, grid is { } whole ? new Board(whole.Size, squareMm ?? whole.Step) : null);
        }

        /// <summary>One camera's views; of pairs those of the side named.</summary>
        /// <param name="side">"left" or "right"; of no meaning without pairs.</param>
        /// <param name="imageSize">As the user gave it, or null.</param>
        public SeenBoards Read(string side, (int Width, int Height)? imageSize)
        {
            JObject[] items = ((JArray)(HasPairs ? _root["pairs"] : _root["images"])!).Select((item, i) => item as JObject
                ?? throw new InputException(_path, FormattableString.Invariant($"view {i + 1} is no object"), Remedy)).ToArray();
            string nameField = HasPairs ? side : "image", pointsField = HasPairs ? side + "_px" : "px", idsField = HasPairs ? side + "_ids" : "ids";
            string[] names = items.Select((item, i) => (string?)(item[nameField] as JValue) ?? FormattableString.Invariant($"{(HasPairs ? side + " " : string.Empty)}view {i + 1}")).ToArray();
            string[] paths = names.Select(name => Path.Combine(Path.GetDirectoryName(Path.GetFullPath(_path))!, Path.GetFileName(name))).ToArray();
            names = UniqueNames.Of(names.Select(name => Path.GetFileName(name)));
            Vector2D[][] px = items.Select((item, i) => Points(item[pointsField], _path, pointsField + " of " + names[i])).ToArray();
            (int width, int height) = imageSize ?? SizeInFile(side) ?? SizeOfPictures(paths) ?? UsualSize(px, side);
            var seen = new SeenBoards(names, paths.Select(path => File.Exists(path) ? path : null).ToArray(), width, height);
            for (int i = 0; i < items.Length; i++)
            {
                Vector2D[] board = items[i][idsField] is JArray ids ? ids.Select(id => BoardPoint(id, names[i])).ToArray() : _boardMm;
                if (board.Length != px[i].Length)
                    throw new InputException(_path, FormattableString.Invariant($"{names[i]} has {px[i].Length} corners, the board has {board.Length}") + Looks(px[i]), "give the board's own size with --board");
                if (ScreenPoints.FirstOutside(px[i], width, height) is string outside)
                {
                    // One bad view of twenty is no reason to go without the others; a wrong size of the pictures is.
                    seen.Reasons[i] = outside;
                    continue;
                }

                if (!BoardView.TryCreate(names[i], board, px[i], out BoardView? view, out string reason))
                    throw new InputException(_path, reason, Remedy);
                seen.Views[i] = view;
            }

            int outsiders = seen.Views.Count(view => view == null);
            if (2 * outsiders > items.Length)
                throw new InputException(_path, FormattableString.Invariant($"{outsiders} of {items.Length} views have corners outside the picture, the first one {seen.Missing().First().Name}: {seen.Missing().First().Reason}"), "correct the corners, or give the pictures' own size with --image-size");
            return seen;
        }

        private Vector2D BoardPoint(JToken id, string view) => id.Type == JTokenType.Integer && (double)id >= 0 && (double)id < _boardMm.Length
            ? _boardMm[(int)id]
            : throw new InputException(_path, $"{view}: {id} is no point of the board, which has {_boardMm.Length}", Remedy);

        private (int Width, int Height)? SizeInFile(string side)
        {
            JToken? size = _root["image_size_" + side] ?? _root["image_size"];
            if (size == null || size.Type == JTokenType.Null)
                return null;
            int[] found = CalibrationJson.ImageSize(size, _path, "image_size");
            return (found[0], found[1]);
        }

        private static (int Width, int Height)? SizeOfPictures(string[] paths)
        {
            using var reader = new PictureFile();
            foreach (string path in paths.Take(1))
            {
                try
                {
                    return reader.TryReadSize(path);
                }
                catch (InputException)
                {
                    // The picture is only a help; the corners stand without it.
                }
            }

            return null;
        }

        private (int Width, int Height) UsualSize(Vector2D[][] px, string side)
        {
            double right = px.SelectMany(view => view).Max(p => p.X), bottom = px.SelectMany(view => view).Max(p => p.Y);
            (int Width, int Height) size = UsualSizes.FirstOrDefault(usual => right < usual.Width && bottom < usual.Height);
            if (size.Width == 0)
                throw new InputException(_path, "does not say how large the pictures were", "give --image-size WxH");
            Notes.Add(FormattableString.Invariant($"the {(HasPairs ? side + " " : string.Empty)}pictures are taken to be {size.Width}×{size.Height}, the smallest usual size that holds all corners; --image-size WxH says it for sure"));
            return size;
        }

        /// <summary>Counts a row of a grid by where the way from corner to corner turns back.</summary>
        private static string Looks(Vector2D[] px)
        {
            for (int columns = BoardSize.Least; columns < px.Length; columns++)
            {
                Vector2D along = px[columns - 1] - px[columns - 2], next = px[columns] - px[columns - 1];
                if (Vector2D.Dot(along, next) >= 0)
                    continue;
                return px.Length % columns == 0 ? FormattableString.Invariant($": it looks like {columns}×{px.Length / columns}") : string.Empty;
            }

            return string.Empty;
        }

        private static (BoardSize Size, double Step)? GridOf(Vector2D[] points)
        {
            int columns = points.Skip(1).TakeWhile(point => point.Y == points[0].Y).Count() + 1;
            if (points.Length % columns != 0 || !BoardSize.TryParse(FormattableString.Invariant($"{columns}x{points.Length / columns}"), out BoardSize size))
                return null;
            double step = points[1].X - points[0].X;
            bool isGrid = step > 0 && Enumerable.Range(0, points.Length).All(i => (points[i] - points[0] - new Vector2D(i % columns, i / columns) * step).Length < 1e-6 * step);
            return isGrid ? (size, step) : null;
        }

        /// <summary>Lists of two numbers, or three with the last 0: the board is flat.</summary>
        private static Vector2D[] Points(JToken? token, string path, string field)
        {
            if (token is not JArray list)
                throw new InputException(path, $"field {field} is missing", Remedy);
            var points = new Vector2D[list.Count];
            for (int i = 0; i < points.Length; i++)
            {
                int count = (list[i] as JArray)?.Count == 3 ? 3 : 2;
                double[] numbers = CalibrationJson.Numbers(list[i], count, path, FormattableString.Invariant($"{field}, point {i + 1}"));
                if (count == 3 && numbers[2] != 0)
                    throw new InputException(path, FormattableString.Invariant($"{field}, point {i + 1}, does not lie in the board's plane"), Remedy);
                points[i] = new Vector2D(numbers[0], numbers[1]);
            }

            return points;
        }
    }
}
