package org.dfra.river.security.robot;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongSupplier;
import org.dfra.core.host.PrivateFiles;
import org.dfra.core.policy.PolicyFacts;
import org.dfra.geometry.GeoPosition;
import org.dfra.river.identity.FlooredClock;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What this process knows about its robot, for the conditions of the policy: read from memory for
 * each decision, and updated by {@link #look}.
 */
final class RobotFacts implements PolicyFacts {

  private static final Logger LOG = LoggerFactory.getLogger(RobotFacts.class);

  private static final String POSITION = "position";

  private final Path folder;
  private final FactFile file;
  private final FlooredClock clock;
  private final LongSupplier nanos;
  private volatile Map<String, NamedFact> named = Map.of();
  private volatile @Nullable SharedPosition position;

  @GuardedBy("this")
  private List<Object> known = List.of();

  @GuardedBy("this")
  private String fault = "";

  /**
   * @param nanos the monotonic clock of the computer, in nanoseconds
   */
  RobotFacts(Path folder, FactFile file, FlooredClock clock, LongSupplier nanos) {
    this.folder = folder;
    this.file = file;
    this.clock = clock;
    this.nanos = nanos;
  }

  @Override
  public Optional<GeoPosition> position() {
    @Nullable SharedPosition shared = position;
    return shared == null ? Optional.empty() : shared.read();
  }

  @Override
  public Optional<Instant> time() {
    return clock.time();
  }

  @Override
  public Optional<String> fact(String name) {
    @Nullable NamedFact fact = named.get(name);
    return fact == null ? Optional.empty() : Optional.of(fact.value());
  }

  /** Where to write the robot's position; null if no rule needs it. */
  @Nullable SharedPosition shared() {
    return position;
  }

  /**
   * Reads the named facts again if they have changed, and maps the position while a rule needs it.
   *
   * @param needsPosition whether a rule of the policy in force needs it
   */
  synchronized void look(boolean needsPosition) {
    try {
      List<Object> now = file.state();
      if (!now.equals(known)) {
        known = now;
        named = Map.of(); // unknown, unless the file can be read
        named = Map.copyOf(file.read());
      }
      lookAtPosition(needsPosition);
      fault = "";
    } catch (IOException e) {
      String reason = String.valueOf(e.getMessage());
      if (!reason.equals(fault)) {
        LOG.error("Facts for the policy are unknown: {}", reason);
        fault = reason;
      }
    }
  }

  @GuardedBy("this")
  private void lookAtPosition(boolean isNeeded) throws IOException {
    @Nullable SharedPosition now = position;
    if (isNeeded && now == null) {
      PrivateFiles.requireFolder(folder);
      position = SharedPosition.open(folder.resolve(POSITION), nanos);
    } else if (!isNeeded && now != null) {
      position = null;
      now.close();
    }
  }
}
