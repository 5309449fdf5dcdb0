package org.dfra.module;

import java.io.Serializable;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.dfra.lifecycle.Incident;

/**
 * A module's history across all its activations, and its reliability.
 *
 * @param since when it was first activated
 * @param activations how often it was activated
 * @param failures how often it failed
 * @param exceptions how many exceptions it caught
 * @param servingTime total time for which it served
 * @param recent the last incidents, the newest last
 */
public record ModuleHistory(
    Instant since,
    long activations,
    long failures,
    long exceptions,
    Duration servingTime,
    List<Incident> recent)
    implements Serializable {

  public ModuleHistory {
    recent = List.copyOf(recent);
  }

  /** Mean time between failures: the time served per failure; empty if there was no failure. */
  public Optional<Duration> meanTimeBetweenFailures() {
    return failures == 0 ? Optional.empty() : Optional.of(servingTime.dividedBy(failures));
  }
}
