namespace LaserTracking.Hands.Model
{
    /// <summary>One operator as the file describes it. Tensors by their number; an input of -1 is left out.</summary>
    internal sealed class TfLiteOperator
    {
        public TfLiteOperator(OperatorCode code, int[] inputs, int output, int options)
        {
            Code = code;
            Inputs = inputs;
            Output = output;
            Options = options;
        }

        public OperatorCode Code { get; }

        public int[] Inputs { get; }

        public int Output { get; }

        /// <summary>Position of the options' table in the file; 0: all defaults.</summary>
        public int Options { get; }
    }
}
