package org.dfra.sim.device.uav;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * Whether the ground station is still there.
 *
 * <pre>
 *   NEVER HEARD --heartbeat--&gt; THERE --silent for a while--&gt; MISSED --for longer--&gt; GIVEN UP
 *                                ^                             |                     |
 *                                +----------heartbeat----------+---------------------+
 * </pre>
 *
 * <p>One that was never heard is not missed: the vehicle is flown by a person. Confined to one
 * thread.
 */
final class GroundStationMonitor {

  /** What has just become of it. */
  enum Change {
    /** Nothing. */
    NONE,
    /** It is missed. */
    LOST,
    /** It is missed for so long that it is waited for no longer. */
    RETURN_DUE
  }

  private final AutopilotSettings settings;
  private @Nullable Instant lastHeartbeat;
  private boolean missed;
  private boolean givenUp;

  GroundStationMonitor(AutopilotSettings settings) {
    this.settings = settings;
  }

  /** It has shown that it lives. */
  void heartbeat(Instant time) {
    lastHeartbeat = time;
    missed = false;
    givenUp = false;
  }

  boolean isMissed() {
    return missed;
  }

  /** Time has passed; only while it flies. */
  Change step(Instant time) {
    if (lastHeartbeat == null) {
      return Change.NONE;
    }
    Duration silence = Duration.between(lastHeartbeat, time).minus(settings.groundStationTimeout());
    if (!missed && silence.compareTo(Duration.ZERO) > 0) {
      missed = true;
      return Change.LOST;
    }
    if (missed && !givenUp && silence.compareTo(settings.returnDelay()) > 0) {
      givenUp = true;
      return Change.RETURN_DUE;
    }
    return Change.NONE;
  }
}
