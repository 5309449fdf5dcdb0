package org.dfra.core.config;

import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;

/** Collects all faults of a description, so that one pass reports them all. */
public final class ConfigurationFaults {

  private record Fault(SourceLocation place, String sentence) {}

  private final Set<Fault> faults = new LinkedHashSet<>();

  /**
   * @param sentence the fault; the remedy
   */
  public void add(SourceLocation place, String sentence) {
    faults.add(new Fault(place, sentence));
  }

  /** Whether there are none. */
  public boolean isEmpty() {
    return faults.isEmpty();
  }

  /** Throws the collected faults, one line each, sorted by file and line. */
  public void throwIfAny() {
    if (faults.isEmpty()) {
      return;
    }
    List<String> files = faults.stream().map(fault -> fault.place().file()).distinct().toList();
    throw new ConfigurationException(
        faults.stream()
            .sorted(
                Comparator.comparingInt((Fault fault) -> files.indexOf(fault.place().file()))
                    .thenComparingInt(fault -> fault.place().line()))
            .map(fault -> fault.place() + ": " + fault.sentence())
            .collect(Collectors.joining("\n")));
  }
}
