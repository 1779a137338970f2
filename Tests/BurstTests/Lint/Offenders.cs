using System;
using System.Runtime.InteropServices;
using Unity.Jobs;

namespace LaserTracking.Burst
{
    /// <summary>One small method for each rule of the lint, which breaks it. Never called.</summary>
    internal static unsafe class Offenders
    {
        private static readonly Random Shared = new Random(1);
        private static readonly int Fixed = Environment.ProcessorCount;
        private static int _changing;

        private interface IShape
        {
            int Area(int side);
        }

        public static int AllocateArray(int count) => new int[count].Length;

        public static void AllocateObject(int* result) => *result = new Random(*result) == null ? 1 : 0;

        public static void Box(int value, IntPtr* result) => *result = ((object)value) == null ? IntPtr.Zero : *result;

        public static void Throw(int value)
        {
            if (value < 0)
                throw null!;
        }

        public static int Catch(int a, int b)
        {
            try
            {
                return a / b;
            }
            finally
            {
                a = 0;
            }
        }

        public static int CallInterface(int side) => Anything().Area(side);

        public static void CallVirtually(int* result) => *result = Shared.Next();

        public static void WriteStatic(int value) => _changing = value;

        public static void ReferToStatic(int value) => Assign(ref _changing, value);

        public static int ReadChangingStatic() => _changing;

        public static bool ReadStaticObject() => Shared == null;

        public static int UseString() => "text".Length;

        public static int UseDelegate(int value) => Call(&KeepsToTheRules, value);

        public static char UseChar(char letter) => letter;

        public static int UseDecimal(decimal* value) => value == null ? 0 : 1;

        public static int UsePacked(Packed* value) => value->Number;

        public static int TakeObject(int[] values) => values == null ? 0 : 1;

        public static int UseArrayInStruct(in WithArray value) => value.Values == null ? 0 : 1;

        public static float CallClassLibrary(float value) => MathF.Sqrt(value);

        public static double RoundToDigits(double value) => Math.Round(value, 2);

        public static int CallNative() => Native();

        public static int Generic<T>(T* value) where T : unmanaged => sizeof(T);

        public static int AddChecked(int a, int b) => checked(a + b);

        public static int AllocateFarAway(int count) => KeepsToTheRules(count) + AllocateArray(count);

        public static int KeepsToTheRules(int count)
        {
            int* sums = stackalloc int[16];
            for (int i = 0; i < 16; i++)
                sums[i] = Math.Max(count, i) % 7 + (int)Math.Sqrt(i) + Fixed;
            var point = new Natural(count, sums[3]);
            return point.Sum() + (count > 3 ? sums[5] : sums[6]);
        }

        public static int CallsConstrained(int side)
        {
            var square = default(Square);
            return square.Area(side);
        }

        private static int Call(delegate*<int, int> function, int value) => function(value);

        private static void Assign(ref int place, int value) => place = value;

        private static IShape Anything() => null!;

        [DllImport("none")]
        private static extern int Native();

        private readonly struct Natural
        {
            private readonly int _x;
            private readonly int _y;

            public Natural(int x, int y)
            {
                _x = x;
                _y = y;
            }

            public int Sum() => _x + _y;
        }

        private struct Square : IShape
        {
            public int Area(int side) => side * side;
        }

        [StructLayout(LayoutKind.Sequential, Pack = 1)]
        public struct Packed
        {
            public byte First;
            public int Number;
        }

#pragma warning disable CS0649
        public struct WithArray
        {
            public int[] Values;
        }

        public struct JobWithArray : IJobFor
        {
            public int[] Values;

            public void Execute(int index) => Values[index] = index;
        }

        public struct JobWithBool : IJobFor
        {
            public bool Flag;

            public void Execute(int index) => Flag = index > 0;
        }

        public struct JobWithBarePointer : IJobFor
        {
            public int* Values;

            public void Execute(int index) => Values[index] = index;
        }
#pragma warning restore CS0649
    }
}
