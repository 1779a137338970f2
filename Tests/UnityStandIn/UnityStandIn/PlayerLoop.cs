// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace UnityStandIn
{
    /// <summary>Play mode in the hands of a test: one call, one frame.</summary>
    public static class PlayerLoop
    {
        /// <summary>
        /// One frame: time goes on, Start where it is due, as many FixedUpdates and physics steps as the time asks for, Update,
        /// LateUpdate, drawing, then what was destroyed goes. Components run by DefaultExecutionOrder, then by age.
        /// </summary>
        /// <param name="deltaSeconds">Since the last frame; not negative.</param>
        public static void Step(double deltaSeconds)
        {
            AdvanceTime(deltaSeconds);
            GraphicsCard.Answer();
            foreach (MonoBehaviour behaviour in InOrder())
            {
                if (behaviour.isActiveAndEnabled && !behaviour.IsStarted)
                {
                    behaviour.IsStarted = true;
                    behaviour.Send("Start");
                }
            }

            while (Time.fixedTimeAsDouble + Time.fixedDeltaTime <= Time.timeAsDouble)
            {
                Time.fixedTimeAsDouble += Time.fixedDeltaTime;
                SendAll("FixedUpdate");
                Physics.SyncTransforms();
            }

            SendAll("Update");
            SendAll("LateUpdate");
            GraphicsCard.Render();
            World.DestroyDoomed();
        }

        /// <summary>Lets time go on without calling anyone, for tests that call a component themselves to see what it allocates.</summary>
        public static void AdvanceTime(double deltaSeconds)
        {
            Time.frameCount++;
            Time.deltaTime = (float)deltaSeconds;
            Time.timeAsDouble += deltaSeconds;
        }

        /// <summary>Destroys everything and sets clock, log and physics settings back, as leaving play mode does.</summary>
        public static void Reset()
        {
            World.Clear();
            ConsoleLog.Clear();
            JobWorkers.Reset();
            Desk.Reset();
            GizmoLines.Drawn.Clear();
            WebCams.Reset();
            GraphicsCard.Reset();
            Time.frameCount = 0;
            Time.timeAsDouble = Time.fixedTimeAsDouble = 0;
            Time.deltaTime = 0;
            Time.fixedDeltaTime = 0.02f;
            Physics.queriesHitTriggers = true;
            Physics.queriesHitBackfaces = false;
        }

        /// <summary>All components of a type in the scene, in order of creation, inactive ones too.</summary>
        public static List<T> All<T>() where T : Component => World.All<T>();

        private static void SendAll(string message)
        {
            foreach (MonoBehaviour behaviour in InOrder())
            {
                // Not before Start: what was added during this very frame begins with the next.
                if (behaviour != null && behaviour.isActiveAndEnabled && behaviour.IsStarted)
                    behaviour.Send(message);
            }
        }

        private static IEnumerable<MonoBehaviour> InOrder() => World.All<MonoBehaviour>().OrderBy(behaviour => behaviour.ExecutionOrder);
    }
}
