package org.dfra.benchmarks.attack;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.ObjectStreamClass;
import java.io.OutputStream;
import java.lang.reflect.Proxy;
import java.util.Optional;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.lookup.ServiceRegistrar;
import net.jini.jeri.tcp.TcpEndpoint;
import org.dfra.river.transport.AbortableEndpoint;
import org.jspecify.annotations.Nullable;

/**
 * Proxies that call from an address of the attacker's choice: a stock proxy is serialized and
 * deserialized, and every JERI endpoint in it gets other sockets. The rest of it is unchanged.
 */
public final class SourceBoundProxies {

  private SourceBoundProxies() {}

  /**
   * The same proxy with other sockets.
   *
   * @param proxy a JERI proxy, or any serializable object that contains some
   * @param sockets for its calls
   * @throws IOException if it cannot be serialized, or deserialized by its own class loader
   */
  public static <T> T of(T proxy, SourceSockets sockets) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (EndpointWriter out = new EndpointWriter(bytes, sockets)) {
      out.writeObject(proxy);
    }
    @Nullable ClassLoader loader = proxy.getClass().getClassLoader();
    try (CopyReader in = new CopyReader(new ByteArrayInputStream(bytes.toByteArray()), loader)) {
      @SuppressWarnings("unchecked") // the copy of a T
      T copy = (T) in.readObject();
      return copy;
    } catch (ClassNotFoundException e) {
      throw new IOException("a class of " + proxy.getClass().getName() + " is not found", e);
    }
  }

  /**
   * The remote proxy in a smart proxy, such as a module's: the outermost that implements a remote
   * interface.
   *
   * @param proxy a serializable object
   * @param type the remote interface
   * @throws IOException if the object cannot be serialized, or contains no such proxy
   */
  public static <R> R remote(Object proxy, Class<R> type) throws IOException {
    try (ProxySearch out = new ProxySearch(type)) {
      out.writeObject(proxy);
      return type.cast(
          out.found()
              .orElseThrow(
                  () ->
                      new IOException(
                          "there is no proxy for " + type.getName() + " in " + proxy.getClass())));
    }
  }

  /**
   * The lookup service at an address, discovered and called with these sockets.
   *
   * @param host its host
   * @param port its port for unicast discovery
   * @throws IOException if it does not answer
   */
  public static ServiceRegistrar registrar(String host, int port, SourceSockets sockets)
      throws IOException {
    try {
      return of(new LookupLocator(host, port, sockets).getRegistrar(), sockets);
    } catch (ClassNotFoundException e) {
      throw new IOException("the lookup service at " + host + ":" + port + " has no proxy here", e);
    }
  }

  /** Serializes an object with other sockets in its endpoints. */
  private static final class EndpointWriter extends ObjectOutputStream {

    private final SourceSockets sockets;

    EndpointWriter(OutputStream out, SourceSockets sockets) throws IOException {
      super(out);
      this.sockets = sockets;
      enableReplaceObject(true);
    }

    @Override
    protected Object replaceObject(Object object) {
      if (object instanceof AbortableEndpoint endpoint) {
        return sockets.bound(endpoint);
      }
      return object instanceof TcpEndpoint tcp
          ? TcpEndpoint.getInstance(tcp.getHost(), tcp.getPort(), sockets)
          : object;
    }
  }

  /** Serializes an object and keeps the first proxy of a type. */
  private static final class ProxySearch extends ObjectOutputStream {

    private final Class<?> type;
    private @Nullable Object found;

    ProxySearch(Class<?> type) throws IOException {
      super(OutputStream.nullOutputStream());
      this.type = type;
      enableReplaceObject(true);
    }

    Optional<Object> found() {
      return Optional.ofNullable(found);
    }

    @Override
    protected Object replaceObject(Object object) {
      if (found == null && Proxy.isProxyClass(object.getClass()) && type.isInstance(object)) {
        found = object;
      }
      return object;
    }
  }

  /** Deserializes with the class loader of the original object. */
  private static final class CopyReader extends ObjectInputStream {

    private final @Nullable ClassLoader loader;

    CopyReader(InputStream in, @Nullable ClassLoader loader) throws IOException {
      super(in);
      this.loader = loader;
    }

    @Override
    protected Class<?> resolveClass(ObjectStreamClass described)
        throws IOException, ClassNotFoundException {
      try {
        return Class.forName(described.getName(), false, loader);
      } catch (ClassNotFoundException e) {
        return super.resolveClass(described); // a primitive type, or one of the attacker's types
      }
    }
  }
}
