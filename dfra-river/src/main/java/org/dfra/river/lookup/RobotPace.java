package org.dfra.river.lookup;

import com.sun.jini.discovery.UnicastSocketTimeout;
import com.sun.jini.thread.WakeupManager;
import com.sun.jini.thread.WakeupManager.ThreadDesc;
import java.lang.reflect.Method;
import java.time.Duration;
import java.util.Arrays;
import java.util.Collections;
import java.util.Iterator;
import java.util.List;
import java.util.Map;
import net.jini.config.Configuration;
import net.jini.core.constraint.ConnectionAbsoluteTime;
import net.jini.core.constraint.InvocationConstraint;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.MethodConstraints;

/**
 * The pace at which lookup services are looked for and registrations are renewed.
 *
 * <p>River's own is an office's: it waits longer and longer between tries, up to a quarter of an
 * hour, and for a peer that falls silent in the middle of one a minute. A robot that comes back
 * into radio range is to be found within seconds.
 */
final class RobotPace {

  /** The longest lease that a module asks of a lookup service, which may grant a shorter one. */
  static final Duration LEASE = Duration.ofSeconds(30);

  /** The longest wait between two tries. */
  static final Duration LONGEST_WAIT = Duration.ofSeconds(2);

  /** How long one try waits for its connection, and then for each answer. */
  static final Duration PATIENCE = Duration.ofSeconds(2);

  private RobotPace() {}

  /** What {@code own} says, and where it says nothing of the pace, this one. */
  static Configuration configuration(Configuration own) {
    return new SuppliedConfiguration(
        own,
        Map.of(
            "net.jini.lookup.JoinManager.wakeupManager", Impatient::new,
            "net.jini.lookup.JoinManager.maxLeaseDuration", LEASE::toMillis,
            "net.jini.lease.LeaseRenewalManager.roundTripTime", PATIENCE::toMillis));
  }

  /** Constraints of a locator: a try that has begun ends soon. */
  static MethodConstraints ofLocators() {
    return new SoonEnded();
  }

  /** Wakes nobody later than in {@link #LONGEST_WAIT}. */
  private static final class Impatient extends WakeupManager {

    Impatient() {
      super(new ThreadDesc(null, true));
    }

    @Override
    public Ticket schedule(long when, Runnable task, ThreadDesc thread) {
      long latest = System.currentTimeMillis() + LONGEST_WAIT.toMillis();
      return super.schedule(Math.min(when, latest), task, thread);
    }

    @Override
    public Ticket schedule(long when, Runnable task) {
      long latest = System.currentTimeMillis() + LONGEST_WAIT.toMillis();
      return super.schedule(Math.min(when, latest), task);
    }
  }

  /** River asks for these at the beginning of each try, so the deadline is always a fresh one. */
  private static final class SoonEnded implements MethodConstraints {

    @Override
    public InvocationConstraints getConstraints(Method method) {
      long millis = PATIENCE.toMillis();
      InvocationConstraint[] wanted = {
        new ConnectionAbsoluteTime(System.currentTimeMillis() + millis),
        new UnicastSocketTimeout((int) millis)
      };
      return new InvocationConstraints(Collections.emptyList(), Arrays.asList(wanted));
    }

    @Override
    @SuppressWarnings("rawtypes") // as River declares it
    public Iterator possibleConstraints() {
      return List.of(getConstraints(Object.class.getMethods()[0])).iterator();
    }

    @Override
    public String toString() {
      return "each try ends within seconds";
    }
  }
}
