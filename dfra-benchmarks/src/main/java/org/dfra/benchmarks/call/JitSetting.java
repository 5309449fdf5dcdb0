package org.dfra.benchmarks.call;

import java.util.List;

/** Which JIT compilers both processes use. */
public enum JitSetting {

  /** As robots do: the first compiler only, and later than it would by itself. */
  C1("C1", "the first compiler only (C1), as robots have it", List.of()),

  /** As a JVM does by itself: both compilers. */
  TIERED(
      "tiered",
      "both compilers (tiered), the default of a JVM",
      List.of("-XX:TieredStopAtLevel=4", "-XX:CompileThresholdScaling=1"));

  private final String label;
  private final String description;
  private final List<String> options;

  JitSetting(String label, String description, List<String> options) {
    this.label = label;
    this.description = description;
    this.options = options;
  }

  /** Its name in tables and records. */
  public String label() {
    return label;
  }

  /** What it is, without a full stop. */
  public String description() {
    return description;
  }

  /** JVM options in addition to those of robots. */
  public List<String> options() {
    return options;
  }
}
