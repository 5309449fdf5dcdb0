package org.dfra.river.registrar;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.lang.ref.WeakReference;
import java.lang.reflect.Method;
import java.util.Collection;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.stream.Collectors;
import net.jini.core.lease.UnknownLeaseException;
import net.jini.core.lookup.ServiceID;
import net.jini.id.Uuid;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.lease.LeaseHolder;
import org.dfra.security.Permissions;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Who has registered the services and listeners of a lookup service. It ends the registrations of
 * members that were revoked, and those that a new policy does not permit.
 *
 * <p>Reggie may have registrations from an earlier process. The first who renews one of those is
 * taken for the one who has made it.
 *
 * <p>Thread-safe. Thread: a daemon, {@code registrar-lost-rights}, while registrations are ended.
 */
final class RegistrationHolders {

  private static final Logger LOG = LoggerFactory.getLogger(RegistrationHolders.class);

  private static final int FEW = 64;

  private final Object reggie;
  private final ReggieState state;
  private final Method cancelService;
  private final Method cancelListener;
  private final Method register;
  private final Method listen;
  private final Permissions permissions;

  /** By service ID or number of the listener's event. */
  private final Map<Object, Registered> held = new ConcurrentHashMap<>();

  @GuardedBy("this")
  private int next = FEW; // size at which it removes expired ones

  private record Registered(Uuid lease, LeaseHolder holder) {}

  /**
   * With the current identity.
   *
   * @param methods the remote methods of reggie
   * @throws ReflectiveOperationException if it is not reggie 2.2.2
   */
  RegistrationHolders(Object reggie, ReggieState state, Collection<Method> methods)
      throws ReflectiveOperationException {
    this.reggie = reggie;
    this.state = state;
    Class<?> type = ReggieFields.owner(reggie);
    this.cancelService =
        ReggieFields.method(type, "cancelServiceLease", ServiceID.class, Uuid.class);
    this.cancelListener = ReggieFields.method(type, "cancelEventLease", long.class, Uuid.class);
    this.register = named("register", methods);
    this.listen = named("notify", methods);
    this.permissions = LeaseHolder.currentPermissions();
  }

  private static Method named(String name, Collection<Method> methods)
      throws NoSuchMethodException {
    return methods.stream()
        .filter(each -> each.getName().equals(name))
        .findFirst()
        .orElseThrow(() -> new NoSuchMethodException("reggie has no remote method " + name));
  }

  /** Watches the lists of revoked certificates and the policies, as long as it is reachable. */
  void start() {
    WeakReference<RegistrationHolders> itself = new WeakReference<>(this);
    Runnable[] end = {() -> {}};
    end[0] =
        CurrentIdentity.onLostRights(
            () -> {
              @Nullable RegistrationHolders present = itself.get();
              if (present == null) {
                end[0].run();
              } else {
                present.rightsChanged();
              }
            });
  }

  /**
   * The client of the call on this thread has registered a service or a listener.
   *
   * @param key a service ID, or the number of the listener's event
   */
  void registered(Object key) {
    @Nullable Uuid lease = state.lease(key);
    if (lease != null) {
      hold(key, lease, LeaseHolder.ofCurrentCall());
    }
  }

  /**
   * The client of the call on this thread has renewed leases.
   *
   * @param keys one key or an array of them
   * @param leases the ID of its lease, or an array of them; a wrong one was not renewed
   */
  void renewed(Object keys, Object leases) {
    if (keys instanceof Object[] several) {
      Object[] its = (Object[]) leases;
      for (int i = 0; i < several.length; i++) {
        renewed(several[i], its[i]);
      }
    } else if (!held.containsKey(keys) && leases.equals(state.lease(keys))) {
      boolean isService = keys instanceof ServiceID;
      Optional<LeaseHolder> holder = LeaseHolder.ofCurrentCall();
      hold(keys, (Uuid) leases, holder.map(each -> each.needing(isService ? register : listen)));
    }
  }

  private void hold(Object key, Uuid lease, Optional<LeaseHolder> holder) {
    if (holder.isEmpty()) {
      return;
    }
    Registered now = new Registered(lease, holder.get());
    held.put(key, now);
    if (isLost(now)) { // since its call was permitted
      endInBackground(Map.of(key, now));
    }
    dropEnded();
  }

  private synchronized void dropEnded() {
    if (held.size() < next) {
      return;
    }
    Set<Object> known = Set.copyOf(held.keySet());
    Set<Object> live = new HashSet<>(state.liveServices(only(ServiceID.class, known)));
    live.addAll(state.liveListeners(only(Long.class, known)));
    known.stream().filter(each -> !live.contains(each)).forEach(held::remove);
    next = Math.max(FEW, 2 * held.size());
  }

  private static <T> Set<T> only(Class<T> type, Set<Object> keys) {
    return keys.stream().filter(type::isInstance).map(type::cast).collect(Collectors.toSet());
  }

  private boolean isLost(Registered each) {
    return each.holder().isRevoked() || !each.holder().isStillPermitted(permissions);
  }

  private void rightsChanged() {
    Map<Object, Registered> lost =
        held.entrySet().stream()
            .filter(each -> isLost(each.getValue()))
            .collect(Collectors.toMap(Map.Entry::getKey, Map.Entry::getValue));
    if (!lost.isEmpty()) {
      endInBackground(lost);
    }
  }

  /** Reggie writes each end to its log first. */
  private void endInBackground(Map<Object, Registered> lost) {
    Thread ending = new Thread(() -> lost.forEach(this::end), "registrar-lost-rights");
    ending.setDaemon(true);
    ending.start();
  }

  private void end(Object key, Registered lost) {
    boolean unused = held.remove(key, lost);
    try {
      @Nullable Object none =
          ReggieFields.call(
              key instanceof ServiceID ? cancelService : cancelListener, reggie, key, lost.lease());
      LOG.info(
          "The registration of {} {} by {} ends, who may no longer have it.",
          key instanceof ServiceID ? "service" : "listener",
          key,
          lost.holder());
    } catch (RuntimeException e) {
      if (!(e.getCause() instanceof UnknownLeaseException)) { // it has ended by itself
        LOG.error("The registration of {} by {} does not end", key, lost.holder(), e);
      }
    }
  }
}
