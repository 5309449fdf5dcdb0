package org.dfra.river.registrar;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.lang.System.Logger.Level;
import java.lang.reflect.Method;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.util.Arrays;
import java.util.Collection;
import java.util.concurrent.TimeUnit;
import net.jini.core.constraint.MethodConstraints;
import net.jini.core.entry.Entry;
import net.jini.core.event.EventRegistration;
import net.jini.core.lookup.ServiceID;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.core.lookup.ServiceRegistration;
import net.jini.jeri.ServerCapabilities;
import org.dfra.directory.RegistrationRefusedException;
import org.dfra.river.access.GuardedDispatcher;
import org.dfra.river.access.ListeningHost;
import org.dfra.river.access.OwnAddresses;
import org.dfra.river.access.RemoteCaller;
import org.dfra.river.registrar.RegistrationRules.RegistrationOrigin;
import org.dfra.security.Caller;
import org.dfra.security.Visibility;
import org.jspecify.annotations.Nullable;

/**
 * A dispatcher in front of reggie. It applies {@link RegistrationRules} to every registration, and
 * {@link ReggieArgumentValidator} to every call. What the guard hides from a caller is neither in
 * an answer nor in an event ({@link VisibleLookup}, {@link VisibleEvents}).
 *
 * <p>If reggie was started from its snapshot, the origin of a registration is unknown. A
 * registration whose entries name the robot counts as the robot's own. Another one counts as made
 * by the host whose numeric address its entries contain. Without such an address it has no origin:
 * only the robot's own computers replace it while its lease is valid.
 *
 * <p>Thread-safe. Registrations are made one after another, as reggie itself does.
 */
final class RegistrarDispatcher extends GuardedDispatcher {

  private static final System.Logger LOG = System.getLogger(RegistrarDispatcher.class.getName());

  /** Limits the log, so that repeated calls of an unknown client do not fill it. */
  private static final long LOG_AGAIN_NANOS = TimeUnit.SECONDS.toNanos(10);

  private static final String REGISTRAR = "com.sun.jini.reggie.Registrar";
  private static final String CHANGE = "modifyAttributes";

  /** A transition of which nothing is seen may be another one that is. */
  private static final int ALL_TRANSITIONS =
      ServiceRegistrar.TRANSITION_MATCH_NOMATCH
          | ServiceRegistrar.TRANSITION_NOMATCH_MATCH
          | ServiceRegistrar.TRANSITION_MATCH_MATCH;

  private final RegistrationPolicy policy;
  private final OwnAddresses own;
  private final ReggieState state;
  private final RobotClaimReader claims;
  private final ReggieArgumentValidator arguments;
  private final ReggieItems items;
  private final VisibleLookup lookup;
  private final RegistrationHolders holders;

  private final RegistrationRules rules; // guarded by this

  @GuardedBy("this")
  private boolean restored;

  @GuardedBy("this")
  private long logged = System.nanoTime() - LOG_AGAIN_NANOS;

  /**
   * See {@link GuardedDispatcher}.
   *
   * @param reggie the lookup service
   * @param policy the owner of the registrar
   * @throws ExportException if it is not reggie 2.2.2, or if {@link GuardedDispatcher} throws it
   */
  public RegistrarDispatcher(
      Collection<Method> methods,
      Remote reggie,
      ServerCapabilities capabilities,
      @Nullable MethodConstraints server,
      @Nullable ClassLoader loader,
      RegistrationPolicy policy)
      throws ExportException {
    super(methods, reggie.getClass(), capabilities, server, loader);
    this.policy = policy;
    @Nullable String host = ListeningHost.of(capabilities);
    try {
      this.own = OwnAddresses.exportedAt(host);
      @Nullable ClassLoader its = ReggieFields.owner(reggie).getClassLoader();
      this.items = new ReggieItems(its);
      this.state = new ReggieState(reggie, items);
      EntryDescriptorReader descriptors = new EntryDescriptorReader(its);
      this.claims = new RobotClaimReader(its, descriptors);
      this.arguments = new ReggieArgumentValidator(its, state, descriptors);
      this.lookup =
          new VisibleLookup(
              state,
              new ReggieMatcher(ReggieFields.owner(reggie), items),
              items,
              new VisibleItems(its, items, claims, descriptors));
      this.holders = new RegistrationHolders(reggie, state, methods);
    } catch (UnknownHostException e) {
      throw new ExportException(
          "host " + host + " is not known; export at an address of this machine", e);
    } catch (ReflectiveOperationException e) {
      throw new ExportException(
          "registrations of this lookup service cannot be guarded: "
              + e.getMessage()
              + "; use reggie 2.2.2",
          e);
    }
    this.rules = new RegistrationRules(policy.robot(), state);
    holders.start();
  }

  /**
   * {@inheritDoc}
   *
   * @throws RegistrationRefusedException if the rules refuse it
   * @throws IllegalArgumentException if River's own client does not send such arguments
   */
  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  protected @Nullable Object invoke(Remote impl, Method method, Object[] args, Collection context)
      throws Throwable {
    if (!method.getDeclaringClass().getName().equals(REGISTRAR)) {
      Object answer = super.invoke(impl, method, args, context);
      return method.getName().equals("getLookupAttributes")
          ? seen((Entry[]) answer, context)
          : answer;
    }
    refusing(() -> arguments.check(method.getName(), args));
    if (VisibleLookup.answers(method.getName())) {
      return read(impl, method, args, context);
    }
    limitRenewal(method.getName(), args);
    return switch (method.getName()) {
      case "register" -> register(impl, method, args, context);
      case "notify" -> listen(impl, method, args, context);
      case CHANGE, "addAttributes", "setAttributes" -> change(impl, method, args, context);
      case "renewServiceLease", "renewEventLease", "renewLeases" -> {
        Object granted = super.invoke(impl, method, args, context);
        holders.renewed(args[0], args[1]);
        yield granted;
      }
      default -> super.invoke(impl, method, args, context);
    };
  }

  /** A call that reads: reggie answers it if its caller sees everything. */
  @SuppressWarnings("rawtypes") // as River declares it
  private @Nullable Object read(Remote impl, Method method, Object[] args, Collection context)
      throws Throwable {
    Visibility seen = visibility(caller(context));
    @Nullable Object answer =
        seen.isComplete()
            ? super.invoke(impl, method, args, context)
            : lookup.answer(method.getName(), args, seen);
    return method.getName().equals("getFieldValues") ? withRobotFirst(answer) : answer;
  }

  /** The attributes of the registrar itself, as a caller sees them. */
  private Entry[] seen(Entry[] own, Collection<?> context) {
    Visibility seen = visibility(caller(context));
    @Nullable Object itself = seen.isComplete() ? null : state.item(state.ownId());
    return itself == null ? own : lookup.ownEntries(own, itself, seen);
  }

  /**
   * Puts the robot before the other values of a field. Only its own computers register under its
   * name, so an emergency stop, which reads the robots in this order, reads its effectors before
   * those of strangers, however many these are.
   */
  private @Nullable Object withRobotFirst(@Nullable Object answer) {
    if (answer instanceof Object[] values) {
      int at = Arrays.asList(values).indexOf(policy.robot());
      if (at > 0) {
        values[at] = values[0];
        values[0] = policy.robot();
      }
    }
    return answer;
  }

  /**
   * Shortens the requested duration of a renewal to the longest lease that reggie grants. Reggie
   * itself grants more, as much as the lease has left: after the system clock was set back by an
   * hour, that is an hour. The lease is shortened within a second ({@code RegistrarLeaseLimiter}),
   * but its holder would renew it too late.
   */
  private void limitRenewal(String method, Object[] args) {
    switch (method) {
      case "renewServiceLease" -> args[2] = Math.min((long) args[2], state.maxServiceLease());
      case "renewEventLease" -> args[2] = Math.min((long) args[2], state.maxListenerLease());
      case "renewLeases" -> {
        Object[] registrations = (Object[]) args[0];
        long[] durations = (long[]) args[2];
        for (int i = 0; i < durations.length; i++) {
          boolean isService = registrations[i] instanceof ServiceID;
          durations[i] =
              Math.min(
                  durations[i], isService ? state.maxServiceLease() : state.maxListenerLease());
        }
      }
      default -> {
        // renews nothing
      }
    }
  }

  @SuppressWarnings("rawtypes") // as River declares it
  private synchronized Object register(
      Remote impl, Method method, Object[] args, Collection context) throws Throwable {
    restore();
    RegistrationOrigin from = source(context);
    Object item = args[0];
    refusing(() -> arguments.check(method.getName(), args)); // others may have registered since
    boolean namesRobot = namesRobot(items.entries(item));
    @Nullable ServiceID id = state.effectiveId(item);
    long bytes = size(from, item);
    refusing(() -> rules.checkService(from, id, namesRobot, bytes));
    Object answer = super.invoke(impl, method, args, context);
    ServiceRegistration registration = (ServiceRegistration) answer;
    rules.addService(from, registration.getServiceID(), namesRobot, bytes);
    holders.registered(registration.getServiceID());
    return registration;
  }

  @SuppressWarnings("rawtypes") // as River declares it
  private synchronized Object listen(Remote impl, Method method, Object[] args, Collection context)
      throws Throwable {
    restore();
    RegistrationOrigin from = source(context);
    long bytes = size(from, args); // template, listener and handback
    refusing(() -> rules.checkListener(from, bytes));
    @Nullable EventFilter filter = filter(args, caller(context));
    EventFilter.CURRENT.set(filter);
    Object registration;
    try {
      registration = super.invoke(impl, method, args, context);
    } finally {
      EventFilter.CURRENT.remove();
    }
    EventRegistration made = (EventRegistration) registration;
    rules.addListener(from, made.getID(), bytes);
    holders.registered(made.getID());
    return registration;
  }

  /**
   * The filter of a listener. It is there even if nothing is hidden yet, since another policy may
   * replace the present one.
   *
   * @return null if nothing is ever hidden from the owner
   */
  private @Nullable EventFilter filter(Object[] args, Caller owner) {
    if (!isGuarded() || owner.standing() == Caller.Standing.OWN) {
      return null;
    }
    int transitions = (int) args[1];
    VisibleEvents filter =
        new VisibleEvents(lookup, items, args[0], transitions, () -> visibility(owner));
    boolean isValid = transitions > 0 && transitions <= ALL_TRANSITIONS; // reggie refuses others
    if (isValid && !visibility(owner).isComplete()) {
      args[1] = ALL_TRANSITIONS;
      return filter.started();
    }
    return filter;
  }

  /** A lease holder changes a registration: the change could claim the robot's name. */
  @SuppressWarnings("rawtypes") // as River declares it
  private synchronized Object change(Remote impl, Method method, Object[] args, Collection context)
      throws Throwable {
    restore();
    RegistrationOrigin from = source(context);
    refusing(() -> arguments.check(method.getName(), args)); // others may have registered since
    Object @Nullable [] entries = (Object[]) args[args.length - 1];
    boolean namesRobot =
        method.getName().equals(CHANGE) ? changesToRobot(entries) : namesRobot(entries);
    refusing(() -> rules.checkEntries(from, namesRobot));
    if (!(args[0] instanceof ServiceID id)) { // reggie refuses it
      return super.invoke(impl, method, args, context);
    }
    long bytes = size(from, state.item(id), entries); // at most, since some may be replaced
    refusing(() -> rules.checkGrowth(from, id, bytes));
    Object result = super.invoke(impl, method, args, context);
    rules.setServiceSize(id, size(from, state.item(id)));
    return result;
  }

  /** Registrations of the robot itself are not measured. */
  private static long size(RegistrationOrigin from, @Nullable Object... registered) {
    return from.isRobotHost() ? 0 : SerializedSize.of(registered);
  }

  private void refusing(Runnable check) {
    try {
      check.run();
    } catch (RegistrationRefusedException | IllegalArgumentException e) {
      log(e);
      throw e;
    }
  }

  private synchronized void log(RuntimeException refusal) {
    long now = System.nanoTime();
    if (now - logged >= LOG_AGAIN_NANOS) {
      logged = now;
      LOG.log(Level.WARNING, refusal.getMessage());
    }
  }

  /** Reads reggie's contents before the first call. */
  @GuardedBy("this")
  private void restore() {
    if (restored) {
      return;
    }
    restored = true;
    for (ReggieState.StoredService each : state.services()) {
      Object[] entries = items.entries(each.item());
      boolean namesRobot = namesRobot(entries);
      RegistrationOrigin presumed = // the host is the registrant's own claim, so never the robot's
          namesRobot
              ? new RegistrationOrigin(null, true)
              : new RegistrationOrigin(
                  RemoteCaller.fromHost(claims.host(entries)).address(), false);
      rules.addService(presumed, each.id(), namesRobot, size(presumed, each.item()));
    }
    for (long each : state.listeners()) {
      rules.addListener(new RegistrationOrigin(null, false), each, 0);
    }
  }

  private boolean namesRobot(Object @Nullable [] entries) {
    return !policy.robot().isEmpty() && claims.anyNamesRobot(entries, policy.robot());
  }

  private boolean changesToRobot(Object @Nullable [] entries) {
    return !policy.robot().isEmpty() && claims.changeMayNameRobot(entries, policy.robot());
  }

  /** The robot's own processes have its key; where nobody has keys, their address counts. */
  private RegistrationOrigin source(Collection<?> context) {
    RemoteCaller caller = RemoteCaller.fromContext(context);
    for (Object each : context) {
      if (each instanceof Caller authenticated) {
        return new RegistrationOrigin(
            caller.address(), authenticated.standing() == Caller.Standing.OWN);
      }
    }
    return source(caller);
  }

  private RegistrationOrigin source(RemoteCaller caller) {
    @Nullable InetAddress address = caller.address();
    return new RegistrationOrigin(
        address, address != null && (own.contains(address) || policy.admits(address)));
  }
}
