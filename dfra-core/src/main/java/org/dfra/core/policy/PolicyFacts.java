package org.dfra.core.policy;

import java.time.Instant;
import java.util.Optional;
import org.dfra.geometry.GeoPosition;

/**
 * What a robot knows about itself, for the conditions of its policy. An unknown fact fails closed:
 * a permit that depends on it does not apply, and a denial does. Thread-safe; its methods return at
 * once and throw nothing.
 */
public interface PolicyFacts {

  /** The robot's position; empty if it is unknown or too old. */
  Optional<GeoPosition> position();

  /** The time in UTC; empty on a robot whose clock was not set. */
  Optional<Instant> time();

  /**
   * A named fact, such as {@code load} with the value {@code none}.
   *
   * @return empty if it is unknown
   */
  Optional<String> fact(String name);

  /** Nothing is known. */
  static PolicyFacts none() {
    return new PolicyFacts() {
      @Override
      public Optional<GeoPosition> position() {
        return Optional.empty();
      }

      @Override
      public Optional<Instant> time() {
        return Optional.empty();
      }

      @Override
      public Optional<String> fact(String name) {
        return Optional.empty();
      }
    };
  }
}
