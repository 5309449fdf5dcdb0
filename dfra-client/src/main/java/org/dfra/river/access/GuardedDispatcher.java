package org.dfra.river.access;

import java.lang.reflect.Method;
import java.net.UnknownHostException;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.util.Collection;
import java.util.Set;
import net.jini.core.constraint.InvocationConstraints;
import net.jini.core.constraint.MethodConstraints;
import net.jini.jeri.ServerCapabilities;
import org.dfra.river.filter.FilteredInvocationDispatcher;
import org.jspecify.annotations.Nullable;

/**
 * A dispatcher that refuses administrative calls from unauthorised clients, before it reads their
 * arguments; see {@link AdministrationPolicy}. It filters all other calls like every dispatcher
 * here.
 *
 * <p>It takes its robot's address from the endpoint that it is exported on. On an endpoint whose
 * host is unknown, every address of this computer is the robot's own.
 */
public class GuardedDispatcher extends FilteredInvocationDispatcher {

  private final Set<Method> administrative;
  private final AdministrationPolicy policy;

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

  /**
   * {@inheritDoc}
   *
   * @throws org.dfra.module.AdministrationRefusedException if the method is administrative and the
   *     client may not administer
   */
  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  protected void checkAccess(
      Remote impl, Method method, InvocationConstraints constraints, Collection context) {
    super.checkAccess(impl, method, constraints, context);
    if (administrative.contains(method)) {
      policy.check(RemoteCaller.fromContext(context), name(method));
    }
  }

  /** The name in refusals. */
  static String name(Method method) {
    return method.getDeclaringClass().getSimpleName() + "." + method.getName();
  }
}
