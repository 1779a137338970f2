using System;
using System.CommandLine;
using LaserTracking.Calibration;
using LaserTracking.Patterns;

namespace LaserTracking.Host.Calibration
{
    /// <summary>The options that board and stereo calibration share.</summary>
    internal sealed class BoardOptions
    {
        private const string PublishedBoard = "8x6";
        private const double PublishedSquareMm = 80;
        private const double LeastSquareMm = 1e-4;
        private const double MostSquareMm = 1e5;

        private readonly Option<string?> _board = new("--board") { HelpName = "WxH", Description = "Inner corners along a row and a column (default: the stored corners' own, else 8x6, the published system's)." };
        private readonly Option<double?> _square = new("--square") { HelpName = "MM", Description = "Side of a square, mm (default: the stored corners' own, else 80)." };
        private readonly Option<string> _model = new("--model") { HelpName = "NAME", Description = "Lens: brown5, rational8 (wide lenses) or radial2 (few views).", DefaultValueFactory = _ => "brown5" };
        private readonly Option<string?> _imageSize = new("--image-size") { HelpName = "WxH", Description = "Width and height of the pictures that stored corners come from, where their file does not say." };
        private readonly Option<bool> _keepAll = new("--keep-all") { Description = "Use also views that do not fit the others." };
        private readonly Option<string?> _pictures = new("--pictures") { HelpName = "DIR", Description = "Draws each view there: corners in their order, and how far each is off." };

        public Option<string?> Corners { get; } = new("--corners") { HelpName = "FILE", Description = "Stored corners (JSON) in place of pictures." };

        public void AddTo(Command command)
        {
            foreach (Option option in new Option[] { Corners, _board, _square, _model, _imageSize, _keepAll, _pictures })
                command.Add(option);
        }

        public bool KeepsAll(ParseResult parsed) => parsed.GetValue(_keepAll);

        public string? Pictures(ParseResult parsed) => parsed.GetValue(_pictures);

        /// <summary>Null when not given.</summary>
        public BoardSize? GivenSize(ParseResult parsed)
        {
            if (parsed.GetValue(_board) is not string text)
                return null;
            return BoardSize.TryParse(text, out BoardSize size) ? size
                : throw new InputException("--board", $"\"{text}\" is no number of inner corners from {BoardSize.Least} to {BoardSize.Most} each way", "write it as 8x6");
        }

        /// <summary>Null when not given.</summary>
        public double? GivenSquareMm(ParseResult parsed)
        {
            if (parsed.GetValue(_square) is not double side)
                return null;
            if (!(side > 0))
                throw new InputException("--square", "must be above 0 mm", "write it as 80");
            return side is >= LeastSquareMm and <= MostSquareMm ? side
                : throw new InputException("--square", FormattableString.Invariant($"{side:G3} mm is no square of a board"), "write it as 80");
        }

        public Board Board(ParseResult parsed)
        {
            BoardSize.TryParse(PublishedBoard, out BoardSize published);
            return new Board(GivenSize(parsed) ?? published, GivenSquareMm(parsed) ?? PublishedSquareMm);
        }

        public LensModel Model(ParseResult parsed) => ModelName(parsed) switch
        {
            "brown5" => LensModel.Brown5,
            "rational8" => LensModel.Rational8,
            "radial2" => LensModel.Radial2,
            string other => throw new InputException("--model", $"there is no lens model \"{other}\"", "choose brown5, rational8 or radial2"),
        };

        public string ModelName(ParseResult parsed) => parsed.GetValue(_model)!;

        /// <summary>Null when not given.</summary>
        public (int Width, int Height)? ImageSize(ParseResult parsed) => parsed.GetValue(_imageSize) is string text ? ScreenPoints.PixelSize(text, "--image-size") : null;
    }
}
