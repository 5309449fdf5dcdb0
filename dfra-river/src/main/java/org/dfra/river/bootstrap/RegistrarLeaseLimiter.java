package org.dfra.river.bootstrap;

import com.sun.jini.thread.ReadersWriter;
import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.dfra.river.registrar.ReggieFields;
import org.jspecify.annotations.Nullable;

/**
 * Holds the leases of a lookup service to what it grants.
 *
 * <p>Reggie writes down at which time of the computer's clock a lease ends. Where that clock is set
 * back by an hour, or reggie reads back what it wrote when the clock was wrong, whoever died is
 * listed for that hour. No lease can have more left than the longest that reggie grants, so one
 * that has is cut to that: its holder renews it, or it ends in time. A clock that is set forward
 * needs nothing: reggie drops what it holds, and each holder learns that from its next renewal and
 * registers anew.
 *
 * <p>Reggie 2.2.2 offers no way to do this, so its fields are used, under its own lock.
 */
final class RegistrarLeaseLimiter {

  /** Reggie's own registration, which never ends. */
  private static final long NEVER = Long.MAX_VALUE;

  /** What a lease may have left above the longest: nothing, but for a clock that is adjusted. */
  private static final long SLACK_MILLIS = TimeUnit.SECONDS.toMillis(1);

  private final ReadersWriter lock;
  private final RegistrationTable services;
  private final RegistrationTable events;
  private final Field listener;

  /**
   * @param reggie the lookup service
   * @throws ReflectiveOperationException if it is no reggie that is known here
   */
  RegistrarLeaseLimiter(Object reggie) throws ReflectiveOperationException {
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
   * @param byTime each registration to itself, in the order in which they end
   * @param longest field of reggie, the longest lease that it grants now, in milliseconds
   * @param notifier what the thread waits for that drops those whose time is over
   * @param expiration field of a registration, milliseconds of the computer's clock
   */
  private record RegistrationTable(
      Object reggie, TreeMap<?, ?> byTime, Field longest, Object notifier, Field expiration) {

    /** How many were cut; the caller holds reggie's lock. */
    int cut(long now) throws IllegalAccessException {
      long most = longest.getLong(reggie);
      List<Object> tooLong = new ArrayList<>();
      for (Object each : byTime.descendingKeySet()) {
        long end = expiration.getLong(each);
        if (end != NEVER && end - now > most + SLACK_MILLIS) {
          tooLong.add(each);
        }
      }
      for (Object each : tooLong) { // which are ordered by what changes
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

  /** The listener of each registration for events that there is now; the same objects. */
  Set<Object> listeners() throws IllegalAccessException {
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
   * Cuts what is too long.
   *
   * @return how many leases were
   */
  int shortenOverlong() throws IllegalAccessException {
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
