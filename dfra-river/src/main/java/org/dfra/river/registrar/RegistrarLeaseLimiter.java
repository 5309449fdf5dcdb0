package org.dfra.river.registrar;

import com.sun.jini.thread.ReadersWriter;
import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * Limits the leases of a lookup service to the longest that it grants.
 *
 * <p>Reggie stores the end of a lease as a time of the computer's clock. If that clock is set back
 * by an hour, or reggie reads back what it wrote while the clock was wrong, a crashed service stays
 * listed for that hour. No lease can have more time left than the longest that reggie grants, so a
 * longer one is cut to that: its holder renews it, or it expires in time. A renewal before the cut
 * is limited by {@code RegistrarDispatcher}. A clock that is set forward needs no action: reggie
 * drops its registrations, and each holder finds out at its next renewal and registers again.
 *
 * <p>Reggie 2.2.2 has no interface for this, so its fields are used, under its own lock.
 */
public final class RegistrarLeaseLimiter {

  /** Reggie's own registration, which never ends. */
  private static final long NEVER = Long.MAX_VALUE;

  /** Tolerance above the longest lease, for clock adjustments only. */
  private static final long SLACK_MILLIS = TimeUnit.SECONDS.toMillis(1);

  private final ReadersWriter lock;
  private final RegistrationTable services;
  private final RegistrationTable events;
  private final Field listener;

  /**
   * @param reggie the lookup service
   * @throws ReflectiveOperationException if it is not a supported version of reggie
   */
  public RegistrarLeaseLimiter(Object reggie) throws ReflectiveOperationException {
    Class<?> type = ReggieFields.owner(reggie);
    lock = (ReadersWriter) ReggieFields.accessible(type, "concurrentObj").get(reggie);
    ClassLoader loader = type.getClassLoader();
    services =
        new RegistrationTable(
            reggie,
            (TreeMap<?, ?>) ReggieFields.accessible(type, "serviceByTime").get(reggie),
            ReggieFields.accessible(type, "maxServiceLease"),
            ReggieFields.accessible(type, "serviceNotifier").get(reggie),
            ReggieFields.accessible(
                Class.forName(type.getName() + "$SvcReg", false, loader), "leaseExpiration"));
    events =
        new RegistrationTable(
            reggie,
            (TreeMap<?, ?>) ReggieFields.accessible(type, "eventByTime").get(reggie),
            ReggieFields.accessible(type, "maxEventLease"),
            ReggieFields.accessible(type, "eventNotifier").get(reggie),
            ReggieFields.accessible(
                Class.forName(type.getName() + "$EventReg", false, loader), "leaseExpiration"));
    listener =
        ReggieFields.accessible(
            Class.forName(type.getName() + "$EventReg", false, loader), "listener");
  }

  /**
   * Reggie's registrations of one kind.
   *
   * @param byTime each registration to itself, in the order of expiration
   * @param longest field of reggie, the longest lease that it grants now, in milliseconds
   * @param notifier the monitor on which the thread that removes expired registrations waits
   * @param expiration field of a registration, milliseconds of the computer's clock
   */
  private record RegistrationTable(
      Object reggie, TreeMap<?, ?> byTime, Field longest, Object notifier, Field expiration) {

    /** Shortens overlong leases and returns their number; the caller holds reggie's lock. */
    int cut(long now) throws IllegalAccessException {
      long most = longest.getLong(reggie);
      List<Object> tooLong = new ArrayList<>();
      for (Object each : byTime.descendingKeySet()) {
        long end = expiration.getLong(each);
        if (end != NEVER && end - now > most + SLACK_MILLIS) {
          tooLong.add(each);
        }
      }
      for (Object each : tooLong) { // the order depends on the field that changes
        byTime.remove(each);
        expiration.setLong(each, now + most);
        put(each);
      }
      return tooLong.size();
    }

    @SuppressWarnings("unchecked") // reggie's map has no types; a registration is key and value
    private void put(Object registration) {
      ((TreeMap<Object, Object>) byTime).put(registration, registration);
    }
  }

  /** The listener of each current registration for events; the same objects. */
  public Set<Object> listeners() throws IllegalAccessException {
    Set<Object> all = Collections.newSetFromMap(new IdentityHashMap<>());
    lock.readLock();
    try {
      for (Object each : events.byTime().keySet()) {
        @Nullable Object its = listener.get(each);
        if (its != null) {
          all.add(its);
        }
      }
    } finally {
      lock.readUnlock();
    }
    return all;
  }

  /**
   * Shortens leases that are too long.
   *
   * @return the number of shortened leases
   */
  public int shortenOverlong() throws IllegalAccessException {
    lock.writeLock();
    try {
      long now = System.currentTimeMillis();
      int cutServices = services.cut(now);
      int cutEvents = events.cut(now);
      if (cutServices > 0) {
        lock.waiterNotify(services.notifier());
      }
      if (cutEvents > 0) {
        lock.waiterNotify(events.notifier());
      }
      return cutServices + cutEvents;
    } finally {
      lock.writeUnlock();
    }
  }
}
