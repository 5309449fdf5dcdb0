package org.dfra.persona;

/**
 * What a behaviour is for, and whether it is at work.
 *
 * @param goal name of what it can reach, e.g. {@code RasterGoal}
 * @param script whether it is made of other behaviours
 * @param phase what it is at, e.g. {@code RUNNING}
 * @param rate how often it looks at its percepts, hertz, above 0
 */
public record BehaviorAttributes(String goal, boolean script, String phase, double rate)
    implements Attributes {

  public BehaviorAttributes {
    Checks.text("goal", goal);
    Checks.text("phase", phase);
    Checks.positive("rate", rate, "Hz");
  }
}
