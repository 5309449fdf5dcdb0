package org.dfra.river.server;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.Serializable;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import net.jini.export.Exporter;
import org.dfra.river.access.AdministrationGuard;
import org.jspecify.annotations.Nullable;

/**
 * Exports by JRMP, with proxies that support calls through any interface. The JDK's own stubs
 * refuse a method that is declared in a non-remote interface, as all of a module's methods are:
 * {@code GPSSensor} is not remote, {@code RemoteGPSSensor} is.
 *
 * <p>JRMP has no dispatcher for access checks. So a guard is exported in the object's place and
 * checks administrative methods. As in every call by JRMP, their arguments are read before an
 * unauthorized caller is refused.
 */
final class JrmpCallsExporter implements Exporter {

  private final Exporter underlying;
  private final String host;

  /** A strong reference, since JRMP holds what it exports weakly. */
  @SuppressWarnings("UnusedVariable")
  @GuardedBy("this")
  private @Nullable Remote guarded;

  /**
   * @param underlying exports by JRMP
   * @param host the address that it listens on
   */
  JrmpCallsExporter(Exporter underlying, String host) {
    this.underlying = underlying;
    this.host = host;
  }

  @Override
  public synchronized Remote export(Remote impl) throws ExportException {
    Remote guard = AdministrationGuard.of(impl, host);
    Remote stub = underlying.export(guard);
    guarded = guard;
    return (Remote)
        Proxy.newProxyInstance(
            stub.getClass().getClassLoader(),
            stub.getClass().getInterfaces(),
            new JrmpInvocationHandler(stub));
  }

  @Override
  public synchronized boolean unexport(boolean force) {
    boolean unexported = underlying.unexport(force);
    if (unexported) {
      guarded = null;
    }
    return unexported;
  }

  /**
   * The former name of {@link JrmpInvocationHandler}, in proxies that lookup services stored or
   * that robots with an earlier release send; until the next release.
   */
  @SuppressWarnings("UnusedVariable") // deserialized only
  private record Calls(Remote stub) implements InvocationHandler, Serializable {

    private Object readResolve() {
      return new JrmpInvocationHandler(stub);
    }

    @Override
    public @Nullable Object invoke(Object proxy, Method method, Object @Nullable [] arguments)
        throws Throwable {
      return new JrmpInvocationHandler(stub).invoke(proxy, method, arguments);
    }
  }
}
