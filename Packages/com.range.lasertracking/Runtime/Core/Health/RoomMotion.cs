using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Health
{
    /// <summary>
    /// Displacement of the picture where the screen is not known. A camera takes everything with it, a projected picture that moves
    /// leaves its border and the room behind. What stayed while most of the view changed, or shows a bright picture's outline, is the
    /// room; the room alone says whether the camera moved. Without any in view nobody can tell.
    /// </summary>
    internal sealed class RoomMotion
    {
        private const int RegionsX = 8, RegionsY = 6, Chosen = 96;

        /// <summary>Bins from which a displacement is looked into.</summary>
        private const double LeastBins = 0.5;

        /// <summary>Cells of the room from which it is known, and that must have moved.</summary>
        private const int LeastRoom = 6, LeastMoved = 4, LeastSurvivors = 6, LeastStayed = 3;

        /// <summary>Cells with something to see without which there is nothing to compare with.</summary>
        private const int LeastToBegin = 5;

        private const double ChangedShare = 0.4, StayedShare = 0.04, SurvivedShare = 0.08, StillBins = 0.3;

        /// <summary>Looks after which a cell that looks otherwise is taken for content; for the room it may be somebody who stands there.</summary>
        private const int LooksOfContent = 5, LooksOfHidden = 150, CutsToSurvive = 2;

        /// <summary>Once the room is known its outline is looked for no oftener, unless it alone had an answer.</summary>
        private const int LooksAnOutline = 25;

        private readonly ViewCells _cells = new ViewCells();
        private readonly ViewShift _solver = new ViewShift(Chosen);
        private readonly BrightOutline _outline = new BrightOutline();
        private readonly int[] _chosen = new int[Chosen];
        private readonly Vector2D[] _went = new Vector2D[Chosen];
        private readonly bool[] _isFound = new bool[Chosen];
        private readonly int[] _best = new int[RegionsX * RegionsY];
        private sbyte[] _verdicts = Array.Empty<sbyte>();
        private BinPicture _now = new BinPicture();
        private BinPicture _next = new BinPicture();
        private Vector2D _expected;
        private int _chosenCount;
        private int _room;
        private int _looks;
        private bool _isAtRest;
        private bool _wasCut;
        private bool _isCut;
        private Vector2D _asked;
        private bool _hasOutline;
        private bool _isByOutline;

        public int BinPx => _now.BinPx;

        private bool IsOutlineDue => _room < LeastRoom || !_isAtRest || _isByOutline || _looks % LooksAnOutline <= 1;

        /// <summary>What was last said is the camera's displacement: the room itself moved, or rests.</summary>
        public bool IsCamera { get; private set; }

        /// <summary>
        /// Takes what this frame shows for the picture to compare with, all of it at once: a camera that moves meanwhile would tear it.
        /// False when the picture is too small or shows too little, as before a camera has found its exposure.
        /// </summary>
        public bool TryRefer(Image image)
        {
            if (_cells.Fit(image))
                _verdicts = new sbyte[_cells.Count];
            if (!_cells.IsLargeEnough)
                return false;
            _next.Fit(image);
            _now.Fit(image);
            _now.FillBand(image, 0, 1);
            _cells.Forget();
            _outline.Reset();
            _looks = 0;
            TakeAll();
            return _chosenCount >= LeastToBegin;
        }

        /// <summary>Reads this frame's share of the next look and works on as much of the last.</summary>
        public void Look(Image image, int frame, int frames)
        {
            _next.FillBand(image, frame, frames);
            for (int row = frame; row < _cells.Rows; row += frames)
            for (int cell = row * _cells.Columns; cell < (row + 1) * _cells.Columns; cell++)
                _cells.Compare(_now, cell);
            for (int i = frame; i < _chosenCount; i += frames)
                _isFound[i] = CellMatch.TryFind(_cells.Then, _now, _cells.X(_chosen[i]), _cells.Y(_chosen[i]), _expected, out _went[i]);
            if (frame == 0)
                _hasOutline = IsOutlineDue;
            if (_hasOutline && frame < BrightOutline.Sides)
                _outline.Look(_now, frame);
        }

        /// <summary>After a look's last frame: what the look before it says, bins. False when nothing can be said.</summary>
        public bool TryAgree(out Vector2D shift)
        {
            bool isKnown = TryJudge(out shift);
            (_now, _next) = (_next, _now);
            _looks++;
            return isKnown;
        }

        /// <summary>The last look is what to compare with from now on; what is known of the room goes with it.</summary>
        /// <param name="shift">How far it went since then.</param>
        /// <param name="isContent">Whatever looks otherwise now is content.</param>
        public void Renew(Vector2D shift, bool isContent)
        {
            for (int cell = 0; cell < _cells.Count && isContent; cell++)
            {
                if (_cells.States[cell] < 0 && _cells.IsStructured(cell))
                    _cells.Kinds[cell] = CellKind.Content;
            }

            _cells.Displace(shift);
            _outline.Displace(_now, shift);
            TakeAll();
        }

        private void TakeAll()
        {
            for (int cell = 0; cell < _cells.Count; cell++)
                _cells.Take(_now, cell);
            _expected = default;
            Choose();
        }

        private bool TryJudge(out Vector2D shift)
        {
            _solver.Clear();
            for (int i = 0; i < _chosenCount; i++)
            {
                if (_isFound[i] && IsWitness(_chosen[i]))
                    _cells.Add(_solver, _chosen[i], _went[i]);
            }

            IsCamera = _room >= LeastRoom;
            bool isKnown = _solver.TrySolve(_expected, out shift);
            Vector2D byOutline = default;
            bool isOutlined = _hasOutline && _outline.TryShift(_now, out byOutline);
            _isByOutline = isOutlined && (!isKnown || (byOutline - shift).Length > LeastBins);
            if (isOutlined && (_isByOutline || shift.Length >= LeastBins))
                (isKnown, shift, IsCamera) = (true, _isByOutline ? byOutline : shift, true);
            else if (isKnown && shift.Length >= LeastBins)
                isKnown = TryAsk(ref shift);
            _isAtRest = isKnown && shift.Length < LeastBins;
            if (_isAtRest || !isKnown)
                Watch(isKnown);
            _expected = shift;
            if (_hasOutline && (_isAtRest || !_outline.IsKnown))
                FindOutline();
            Choose();
            return isKnown;
        }

        /// <summary>Whose displacement counts: the room's where it is known, else of all that never changed.</summary>
        private bool IsWitness(int cell) => _room >= LeastRoom ? _cells.Kinds[cell] == CellKind.Room : _cells.Kinds[cell] != CellKind.Content;

        /// <summary>Many cells went by a displacement: did all?</summary>
        private bool TryAsk(ref Vector2D shift)
        {
            int moved = 0, stayed = 0;
            for (int cell = 0; cell < _cells.Count; cell++)
            {
                _verdicts[cell] = 0;
                if (!IsWitness(cell) || !_cells.IsStructured(cell))
                    continue;
                _verdicts[cell] = (sbyte)CellMatch.Verdict(_cells.Then, _now, _cells.X(cell), _cells.Y(cell), shift);
                moved += _verdicts[cell] > 0 ? 1 : 0;
                stayed += _verdicts[cell] < 0 ? 1 : 0;
            }

            bool isRest = IsCamera ? stayed > moved : stayed >= LeastStayed && stayed >= StayedShare * (moved + stayed);
            if (isRest)
            {
                // A look in the midst of a jump shows a part of it only.
                bool isSettled = (shift - _asked).Length < StillBins, isNew = isSettled && !_isCut && stayed >= SurvivedShare * (moved + stayed);
                _asked = shift;
                _isCut |= isNew;
                for (int cell = 0; cell < _cells.Count; cell++)
                {
                    if (_verdicts[cell] > 0 && isSettled)
                        Leave(cell, 1);
                    else if (_verdicts[cell] < 0 && isNew)
                        Survive(cell);
                }

                shift = default;
                return true;
            }

            return moved >= LeastMoved && (!IsCamera || moved >= 3 * stayed);
        }

        /// <summary>The view rests, or shows too much that is new: which cells are content, which the room?</summary>
        private void Watch(bool isRest)
        {
            int structured = 0, changed = 0, survivors = 0;
            for (int cell = 0; cell < _cells.Count; cell++)
            {
                int state = _cells.States[cell];
                structured += _cells.IsStructured(cell) || state < 0 ? 1 : 0;
                changed += state < 0 ? 1 : 0;
                survivors += state > 0 && _cells.Kinds[cell] != CellKind.Content ? 1 : 0;
            }

            // A look in the midst of a cut shows a part of it only: the next one counts.
            bool isCut = changed >= ChangedShare * structured && survivors >= LeastSurvivors && survivors >= SurvivedShare * structured && IsStill();
            bool isNew = isCut && _wasCut && !_isCut;
            _isCut = isCut && _wasCut;
            _wasCut = isCut;
            _asked = default;
            for (int cell = 0; cell < _cells.Count; cell++)
            {
                int state = _cells.States[cell];
                if (_cells.Kinds[cell] == CellKind.Content)
                {
                    if (state <= 0)
                        _cells.Take(_now, cell);
                    continue;
                }

                if (state > 0)
                    _cells.Away[cell] = 0;
                if (state > 0 && isNew)
                    Survive(cell);
                else if (state < 0 && (isRest || _isCut))
                    Leave(cell, LooksOfContent);
            }
        }

        /// <summary>What did not change lies exactly where it lay, along both axes.</summary>
        private bool IsStill()
        {
            _solver.Clear();
            for (int i = 0; i < _chosenCount; i++)
            {
                if (_isFound[i] && _cells.States[_chosen[i]] > 0 && _cells.Kinds[_chosen[i]] != CellKind.Content)
                    _cells.Add(_solver, _chosen[i], _went[i]);
            }

            return _solver.TrySolve(default, out Vector2D shift) && shift.Length < StillBins;
        }

        private void Survive(int cell)
        {
            if (++_cells.Survived[cell] >= CutsToSurvive)
                _cells.Kinds[cell] = CellKind.Room;
        }

        private void Leave(int cell, int looks)
        {
            if (_cells.Kinds[cell] == CellKind.Room)
                looks = LooksOfHidden;
            if (++_cells.Away[cell] < looks)
                return;

            // Where nothing was to be seen nothing has gone: the light may have come on.
            if (_cells.IsStructured(cell))
                _cells.Kinds[cell] = CellKind.Content;
            _cells.Survived[cell] = 0;
            _cells.Take(_now, cell);
        }

        private void FindOutline()
        {
            if (!_outline.TryFinish(_now, _isAtRest))
                return;
            for (int side = 0; side < BrightOutline.Sides; side++)
            {
                Vector2D from = _outline.Corners[side], way = _outline.Corners[(side + 1) % BrightOutline.Sides] - from;
                for (double at = 0; at <= way.Length; at += CellMatch.Size / 4.0)
                {
                    Vector2D p = from + way * (at / way.Length);
                    int column = (int)Math.Floor(p.X / CellMatch.Size), row = (int)Math.Floor(p.Y / CellMatch.Size);
                    if (column < 0 || row < 0 || column >= _cells.Columns || row >= _cells.Rows)
                        continue;
                    int cell = row * _cells.Columns + column;
                    if (_cells.Kinds[cell] == CellKind.Room)
                        continue;
                    _cells.Kinds[cell] = CellKind.Room;
                    if (_cells.States[cell] <= 0)
                        _cells.Take(_now, cell);
                }
            }
        }

        /// <summary>The cells to follow: the best of each part of the view, then more of the room.</summary>
        private void Choose()
        {
            _room = 0;
            for (int i = 0; i < _best.Length; i++)
                _best[i] = -1;
            for (int cell = 0; cell < _cells.Count; cell++)
            {
                if (!_cells.IsStructured(cell))
                    continue;
                _room += _cells.Kinds[cell] == CellKind.Room ? 1 : 0;
                int region = cell / _cells.Columns * RegionsY / _cells.Rows * RegionsX + cell % _cells.Columns * RegionsX / _cells.Columns;
                if (_best[region] < 0 || IsBetter(cell, _best[region]))
                    _best[region] = cell;
            }

            _chosenCount = 0;
            foreach (int cell in _best)
            {
                if (cell >= 0)
                    _chosen[_chosenCount++] = cell;
            }

            int skip = 1 + _room / (Chosen - _best.Length), nth = 0;
            for (int cell = 0; cell < _cells.Count && _chosenCount < Chosen; cell++)
            {
                if (_cells.Kinds[cell] == CellKind.Room && _cells.IsStructured(cell) && nth++ % skip == 0 && Array.IndexOf(_best, cell) < 0)
                    _chosen[_chosenCount++] = cell;
            }
        }

        private bool IsBetter(int cell, int other)
        {
            int rank = _cells.Kinds[cell] == CellKind.Content ? -1 : (int)_cells.Kinds[cell], otherRank = _cells.Kinds[other] == CellKind.Content ? -1 : (int)_cells.Kinds[other];
            return rank != otherRank ? rank > otherRank : _cells.Worth(cell) > _cells.Worth(other);
        }
    }
}
