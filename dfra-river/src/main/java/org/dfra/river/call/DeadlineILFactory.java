package org.dfra.river.call;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.time.Duration;
import java.util.Collection;
import net.jini.core.constraint.MethodConstraints;
import net.jini.jeri.BasicILFactory;
import net.jini.jeri.InvocationDispatcher;
import net.jini.jeri.ObjectEndpoint;
import net.jini.jeri.ServerCapabilities;
import org.dfra.river.filter.FilteredInvocationDispatcher;
import org.jspecify.annotations.Nullable;

/**
 * JERI's invocation layer with a deadline on every call: what DFRA's exporters are configured with.
 *
 * <p>In a Jini configuration file:
 *
 * <pre>
 *   exporter = new BasicJeriExporter(endpoint, new DeadlineILFactory(2000L), false, true);
 * </pre>
 */
public final class DeadlineILFactory extends BasicILFactory {

  /** How long an answer is awaited where nothing else is configured. */
  public static final Duration DEFAULT_DEADLINE = Duration.ofSeconds(2);

  private final Duration deadline;

  /** Calls that must be answered within {@link #DEFAULT_DEADLINE}. */
  public DeadlineILFactory() {
    this(DEFAULT_DEADLINE.toMillis());
  }

  /**
   * @param deadlineMillis how long an answer is awaited, in milliseconds, at least 1
   */
  public DeadlineILFactory(long deadlineMillis) {
    this(null, null, null, Duration.ofMillis(deadlineMillis));
  }

  /**
   * @param server the server's constraints, or null for none
   * @param permission the permission class that guards each call, or null for none
   * @param loader the loader that defines the proxy, or null for the implementation's
   * @param deadline how long an answer is awaited, at least a millisecond
   */
  public DeadlineILFactory(
      @Nullable MethodConstraints server,
      @Nullable Class<?> permission,
      @Nullable ClassLoader loader,
      Duration deadline) {
    super(server, permission, loader);
    if (deadline.toMillis() < 1) {
      throw new IllegalArgumentException("deadline " + deadline + " is shorter than 1 ms");
    }
    this.deadline = deadline;
  }

  @Override
  protected InvocationHandler createInvocationHandler(
      Class[] interfaces, Remote impl, ObjectEndpoint endpoint) throws ExportException {
    super.createInvocationHandler(interfaces, impl, endpoint); // refuses what cannot be served
    return new DeadlineInvocationHandler(endpoint, getServerConstraints(), deadline);
  }

  /** Filters the arguments of every call before they are built. */
  @Override
  @SuppressWarnings({"rawtypes", "unchecked"}) // as River declares it
  protected InvocationDispatcher createInvocationDispatcher(
      Collection methods, Remote impl, ServerCapabilities capabilities) throws ExportException {
    return new FilteredInvocationDispatcher(
        (Collection<Method>) methods,
        capabilities,
        getServerConstraints(),
        getPermissionClass(),
        getClassLoader());
  }

  /**
   * A proxy for an object whose endpoint is known beforehand.
   *
   * @param endpoint where the object is exported, and under which identity
   * @param deadline how long an answer is awaited
   * @param loader the loader that defines the proxy
   * @param interfaces what the proxy implements
   */
  public static Object proxy(
      ObjectEndpoint endpoint, Duration deadline, ClassLoader loader, Class<?>... interfaces) {
    return Proxy.newProxyInstance(
        loader, interfaces, new DeadlineInvocationHandler(endpoint, null, deadline));
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return super.equals(other)
        && other instanceof DeadlineILFactory factory
        && factory.deadline.equals(deadline);
  }

  @Override
  public int hashCode() {
    return 31 * super.hashCode() + deadline.hashCode();
  }
}
