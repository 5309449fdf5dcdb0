package org.dfra.recruit.agent;

import java.time.Duration;
import java.util.Optional;
import org.dfra.agent.HelpCall;
import org.dfra.geometry.GeoPosition;

/**
 * An agent's interface to its robot. Its methods do not block and do not call the agent back before
 * they return; a {@link TravelListener} receives the results of longer operations.
 */
public interface RobotPort {

  /** Receives the result of a trip, once. */
  interface TravelListener {

    /** The robot has arrived. */
    void arrived();

    /** The robot will not arrive; the reason is a clause. */
    void failed(String why);
  }

  /** Whether it can observe the percept. */
  boolean canObserve(String percept);

  /**
   * Whether it is available: it can move, and no other client has stopped or sent it. Its own work,
   * which it would interrupt, does not count.
   */
  boolean isAvailable();

  /** The reason of its hold after a stop, as a clause; empty where it is not held. */
  default Optional<String> holdReason() {
    return Optional.empty();
  }

  /** An operator ends the hold. */
  default void endHold() {}

  /** Whether it has work of its own, which it would interrupt. */
  boolean hasOwnWork();

  /** Whether that place is in its team's field. */
  boolean isInField(GeoPosition place);

  /** The time to reach the place; empty where it is unknown or unreachable. */
  Optional<Duration> eta(GeoPosition place);

  /** Charge left, 0 is empty, 1 is full; 1 where it is unknown. */
  double battery();

  /**
   * Interrupts its work, to be resumed later, and travels to the place.
   *
   * @param leaseEnd when the robot's lease of the task ends, nanoseconds of its agent's scheduler.
   *     From then on the robot does not move for this call. It stops by itself, since its agent may
   *     be suspended
   */
  void travelTo(HelpCall call, long leaseEnd, TravelListener listener);

  /**
   * Changes the end of its task lease, given to {@link #travelTo}, without a stop. Does nothing
   * where it is not on its way.
   *
   * @param leaseEnd the new end, as there
   */
  void extendLease(long leaseEnd);

  /** Starts to observe the percept at the place. */
  void observe(HelpCall call);

  /**
   * Ends the trip or the observation, and resumes the interrupted work; also that of an earlier
   * process. Does nothing where there is none.
   */
  void resumeOwnWork();
}
