package org.dfra.recruit.agent;

import java.time.Duration;
import java.util.Optional;
import org.dfra.agent.HelpCall;
import org.dfra.geometry.GeoPosition;

/**
 * What an agent asks of its robot. Its methods do not block and do not call the agent back before
 * they return; what takes its time is told to a {@link TravelListener}.
 */
public interface RobotPort {

  /** Is told how a journey went, once. */
  interface TravelListener {

    /** It is at the place. */
    void arrived();

    /** It will not get there; why, as a clause. */
    void failed(String why);
  }

  /** Whether it can observe that. */
  boolean canObserve(String percept);

  /**
   * Whether it may be asked at all: it can move, and nobody else has it stopped or sent anywhere.
   * Work of its own that it would leave does not count.
   */
  boolean isAvailable();

  /** Why it is held, since somebody stopped it, as a clause; nothing where it is not held. */
  default Optional<String> holdReason() {
    return Optional.empty();
  }

  /** A person lets it go on. */
  default void endHold() {}

  /** Whether it has work of its own, which it would leave. */
  boolean hasOwnWork();

  /** Whether that place is in the field in which its team works. */
  boolean isInField(GeoPosition place);

  /** How long it would take to be there; nothing where it does not know, or cannot get there. */
  Optional<Duration> eta(GeoPosition place);

  /** Charge left, 0 is empty, 1 is full; 1 where it does not know. */
  double battery();

  /**
   * Leaves what it does, for later, and goes there.
   *
   * @param leaseEnd when the robot's lease of the task ends, nanoseconds of its agent's scheduler.
   *     From then on the robot does not move for this call. It stops by itself, since its agent may
   *     be suspended
   */
  void travelTo(HelpCall call, long leaseEnd, TravelListener listener);

  /**
   * Its lease of the task ends at another time than was said to {@link #travelTo}. It goes on
   * without a stop. Does nothing where it is not on its way.
   *
   * @param leaseEnd when it ends now, as there
   */
  void extendLease(long leaseEnd);

  /** Observes what it was called for; it is there. */
  void observe(HelpCall call);

  /**
   * Ends the journey or the observing, and goes on with what it left; also what an earlier process
   * began or left. Does nothing where there is nothing of that.
   */
  void resumeOwnWork();
}
