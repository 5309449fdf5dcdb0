package org.dfra.core.policy;

import java.time.Instant;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.dfra.geometry.GeoPosition;
import org.jspecify.annotations.Nullable;

/** Facts that a test sets. */
final class SettableFacts implements PolicyFacts {

  @Nullable GeoPosition position;
  @Nullable Instant time;
  final Map<String, String> named = new HashMap<>();

  @Override
  public Optional<GeoPosition> position() {
    return Optional.ofNullable(position);
  }

  @Override
  public Optional<Instant> time() {
    return Optional.ofNullable(time);
  }

  @Override
  public Optional<String> fact(String name) {
    return Optional.ofNullable(named.get(name));
  }
}
