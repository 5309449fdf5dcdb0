package org.dfra.sim.device.uav;

import java.time.Duration;
import java.time.Instant;
import org.jspecify.annotations.Nullable;

/**
 * Detects the loss of the ground station.
 *
 * <pre>
 *   NEVER SEEN --heartbeat--&gt; PRESENT --timeout--&gt; LOST --longer timeout--&gt; GIVEN UP
 *                                ^                  |                          |
 *                                +----heartbeat-----+--------------------------+
 * </pre>
 *
 * <p>Without any heartbeat yet, there is no loss: a human pilot flies the vehicle. Confined to one
 * thread.
 */
final class GroundStationMonitor {

  /** The change of state. */
  enum Change {
    /** No change. */
    NONE,
    /** The ground station is lost. */
    LOST,
    /** It was lost for so long that the vehicle returns. */
    RETURN_DUE
  }

  private final AutopilotSettings settings;
  private @Nullable Instant lastHeartbeat;
  private boolean missed;
  private boolean givenUp;

  GroundStationMonitor(AutopilotSettings settings) {
    this.settings = settings;
  }

  /** A heartbeat was received. */
  void heartbeat(Instant time) {
    lastHeartbeat = time;
    missed = false;
    givenUp = false;
  }

  boolean isMissed() {
    return missed;
  }

  /** Advances the time; call it only in flight. */
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
