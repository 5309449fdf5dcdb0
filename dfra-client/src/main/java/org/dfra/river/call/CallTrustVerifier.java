package org.dfra.river.call;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import java.rmi.RemoteException;
import net.jini.security.TrustVerifier;
import org.dfra.river.transport.SourceBoundEndpoint;
import org.dfra.river.transport.TransportEndpoint;
import org.jspecify.annotations.Nullable;

/**
 * Verifies proxies whose calls have a deadline, their invocation handlers and their endpoints.
 * River's own verifier accepts only its own classes. {@link net.jini.security.Security} finds this
 * one as a service.
 *
 * <p>Trusted is what has exactly these classes, as this class loader defines them: its code is then
 * DFRA's, and not what a stranger sent along. Whether the server is the right one is a question of
 * constraints.
 */
public final class CallTrustVerifier implements TrustVerifier {

  /** Called by River. */
  public CallTrustVerifier() {}

  @Override
  public boolean isTrustedObject(@Nullable Object object, Context context) throws RemoteException {
    if (object == null || context == null) {
      throw new NullPointerException(object == null ? "object" : "context");
    }
    if (object instanceof TransportEndpoint || object instanceof SourceBoundEndpoint) {
      return true; // an address, and no code
    }
    if (object instanceof DeadlineInvocationHandler handler) {
      return context.isTrustedObject(handler.getObjectEndpoint())
          && (handler.getServerConstraints() == null
              || context.isTrustedObject(handler.getServerConstraints()));
    }
    if (!Proxy.isProxyClass(object.getClass())
        || !isVisible(object.getClass().getClassLoader(), context.getClassLoader())) {
      return false;
    }
    InvocationHandler handler = Proxy.getInvocationHandler(object);
    return handler instanceof DeadlineInvocationHandler && context.isTrustedObject(handler);
  }

  /** Whether a loader is the given one or one of its parents. */
  private static boolean isVisible(@Nullable ClassLoader loader, @Nullable ClassLoader from) {
    @Nullable ClassLoader at = from == null ? Thread.currentThread().getContextClassLoader() : from;
    while (at != null) {
      if (at == loader) {
        return true;
      }
      at = at.getParent();
    }
    return loader == null;
  }
}
