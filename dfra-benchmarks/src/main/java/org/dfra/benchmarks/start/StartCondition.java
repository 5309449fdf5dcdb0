package org.dfra.benchmarks.start;

import java.util.List;

/** With which options the processes of the measured robots start. */
public enum StartCondition {

  /** As a JVM starts by itself: its own archive at any address, its own size of the heap. */
  BEFORE(
      "without archive", List.of("-XX:ArchiveRelocationMode=1", "-XX:InitialRAMPercentage=1.5625")),

  /** As robots start. */
  AFTER("with archive", List.of());

  private final String label;
  private final List<String> options;

  StartCondition(String label, List<String> options) {
    this.label = label;
    this.options = options;
  }

  /** Its name in tables and records. */
  public String label() {
    return label;
  }

  /** JVM options of groups, after those of robots. */
  List<String> options() {
    return options;
  }

  /** Whether phoenix and groups start from the archive of robots' processes. */
  boolean hasArchive() {
    return this == AFTER;
  }
}
