package org.dfra.river.access;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.lang.reflect.Method;
import java.net.UnknownHostException;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.util.Collection;
import java.util.List;
import java.util.Set;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.MethodConstraints;
import net.jini.jeri.InboundRequest;
import net.jini.jeri.ServerCapabilities;
import org.dfra.river.filter.FilteredInvocationDispatcher;
import org.dfra.security.AccessRefusedException;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Decision;
import org.dfra.security.Guard;
import org.dfra.security.Visibility;
import org.jspecify.annotations.Nullable;

/**
 * A dispatcher that refuses calls before it reads their arguments. On a {@link GuardedEndpoint} the
 * endpoint's guard decides about every call. On others, administrative calls from unauthorised
 * clients are refused; see {@link AdministrationPolicy}. It filters all other calls like every
 * dispatcher here.
 *
 * <p>It takes its robot's address from the endpoint that it is exported on. On an endpoint whose
 * host is unknown, every address of this computer is the robot's own.
 */
public class GuardedDispatcher extends FilteredInvocationDispatcher {

  private final Set<Method> administrative;
  private final AdministrationPolicy policy;
  private final @Nullable GuardedEndpoint endpoint;

  /**
   * As the constructor of {@link FilteredInvocationDispatcher}.
   *
   * @param methods the remote methods
   * @param type class of the remote object, whose interfaces mark the administrative methods
   * @param capabilities the endpoint that it is exported on
   * @throws ExportException if the server's constraints cannot be met, the endpoint's host is
   *     unknown, or the configured addresses are invalid
   */
  public GuardedDispatcher(
      Collection<Method> methods,
      Class<?> type,
      ServerCapabilities capabilities,
      @Nullable MethodConstraints server,
      @Nullable ClassLoader loader)
      throws ExportException {
    super(methods, capabilities, server, null, loader);
    this.administrative = AdministrativeMethods.among(methods, type);
    this.policy = policy(capabilities);
    this.endpoint = GuardedEndpoint.of(capabilities);
  }

  private static AdministrationPolicy policy(ServerCapabilities capabilities)
      throws ExportException {
    @Nullable String host = ListeningHost.of(capabilities);
    try {
      return AdministrationPolicy.exportedAt(host);
    } catch (UnknownHostException e) {
      throw new ExportException(
          "host " + host + " is not known; export at an address of this machine", e);
    } catch (IllegalArgumentException e) {
      throw new ExportException(
          "the system property " + AdministrationPolicy.PROPERTY + ": " + e.getMessage(), e);
    }
  }

  /** Verifies the credential that the call carries, if it has one, before its method is read. */
  @Override
  protected long readMethodNumber(ObjectInputStream in, Collection<Object> context)
      throws IOException {
    long number = super.readMethodNumber(in, context);
    if (number != CallCredential.MARK) {
      return number;
    }
    byte[] credential = CallCredential.read(in);
    for (Object each : List.copyOf(context)) {
      if (each instanceof CredentialPeer peer) { // on others nobody could be authenticated
        peer.receive(credential, context);
      }
    }
    return super.readMethodNumber(in, context);
  }

  /**
   * {@inheritDoc} The call that the endpoint's guard permits is {@link PermittedCall#current} then.
   *
   * @throws AccessRefusedException if the endpoint's guard refuses the call
   * @throws org.dfra.module.AdministrationRefusedException if the endpoint authenticates nobody,
   *     and the method is administrative and the client may not administer
   */
  @Override
  @SuppressWarnings({"rawtypes", "unchecked"}) // as River declares it
  protected void checkAccess(
      Remote impl, Method method, InvocationConstraints constraints, Collection context) {
    super.checkAccess(impl, method, constraints, context);
    if (endpoint != null) {
      ask(endpoint, impl, method, context);
    } else if (administrative.contains(method)) {
      policy.check(RemoteCaller.fromContext(context), name(method));
    }
  }

  /** {@inheritDoc} Measures the call too, if the endpoint's guard wants to know what it uses. */
  @Override
  @SuppressWarnings({"rawtypes", "unchecked"}) // as River declares it
  public void dispatch(Remote impl, InboundRequest request, Collection context) {
    @Nullable Guard guard = endpoint == null ? null : endpoint.guard();
    @Nullable MeteredCall metered = guard == null ? null : MeteredCall.begin(guard, request);
    if (metered == null) {
      super.dispatch(impl, request, context);
      return;
    }
    context.add(metered);
    try {
      super.dispatch(impl, request, context);
    } finally {
      metered.dispatched();
    }
  }

  private static void ask(
      GuardedEndpoint endpoint, Remote impl, Method method, Collection<Object> context) {
    String object = impl instanceof GuardedObject named ? named.guardedName() : "";
    AccessRequest request =
        new AccessRequest(caller(context), endpoint.robot(), object, impl.getClass(), method);
    @Nullable Guard guard = endpoint.guard();
    if (guard == null) {
      throw new IllegalStateException("an endpoint has lost its guard");
    }
    Decision decision = guard.decide(request);
    if (!decision.isPermitted()) {
      throw new AccessRefusedException(
          request.methodName()
              + (object.isEmpty() ? "" : " of " + object)
              + " is refused to "
              + request.caller()
              + " by rule "
              + decision.rule()
              + ": "
              + decision.reason());
    }
    for (Object each : context) {
      if (each instanceof MeteredCall metered) {
        metered.permitted(request);
      }
    }
    context.add(request); // what it obtains is judged by it later
  }

  /** What a caller sees of what a lookup service lists; everything if nobody is authenticated. */
  protected final Visibility visibility(Caller caller) {
    @Nullable Guard guard = endpoint == null ? null : endpoint.guard();
    if (endpoint != null && guard == null) {
      throw new IllegalStateException("an endpoint has lost its guard");
    }
    return guard == null ? Visibility.ALL : guard.visibility(caller);
  }

  /** Whether callers are authenticated. */
  protected final boolean isGuarded() {
    return endpoint != null;
  }

  /** Who makes a call. */
  protected static Caller caller(Collection<?> context) {
    for (Object each : context) {
      if (each instanceof Caller caller) {
        return caller;
      }
    }
    return Caller.stranger(RemoteCaller.fromContext(context).toString());
  }

  /** The name in refusals. */
  static String name(Method method) {
    return method.getDeclaringClass().getSimpleName() + "." + method.getName();
  }
}
