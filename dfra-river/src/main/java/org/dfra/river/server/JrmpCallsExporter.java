package org.dfra.river.server;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
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
  private @Nullable Remote guarded; // guarded by this

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
            stub.getClass().getClassLoader(), stub.getClass().getInterfaces(), new Calls(stub));
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
   * Makes calls by the stub's reference. Method numbers (hashes) follow the RMI specification,
   * section 8.3.
   *
   * @param stub the JDK's stub
   */
  private record Calls(Remote stub) implements InvocationHandler, Serializable {

    @Override
    public @Nullable Object invoke(Object proxy, Method method, Object @Nullable [] arguments)
        throws Throwable {
      if (method.getDeclaringClass() == Object.class) {
        return switch (method.getName()) {
          case "equals" ->
              arguments != null
                  && arguments[0] != null
                  && Proxy.isProxyClass(arguments[0].getClass())
                  && equals(Proxy.getInvocationHandler(arguments[0]));
          case "hashCode" -> hashCode();
          default -> toString();
        };
      }
      RemoteObjectInvocationHandler handler =
          (RemoteObjectInvocationHandler) Proxy.getInvocationHandler(stub);
      return handler.getRef().invoke(stub, method, arguments, number(method));
    }

    private static long number(Method method) {
      String descriptor =
          java.lang.invoke.MethodType.methodType(method.getReturnType(), method.getParameterTypes())
              .toMethodDescriptorString();
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      try (DataOutputStream out = new DataOutputStream(bytes)) {
        out.writeUTF(method.getName() + descriptor);
        byte[] digest = MessageDigest.getInstance("SHA").digest(bytes.toByteArray());
        return ByteBuffer.wrap(digest).order(ByteOrder.LITTLE_ENDIAN).getLong();
      } catch (IOException e) {
        throw new UncheckedIOException(e); // writing to memory does not fail
      } catch (NoSuchAlgorithmException e) {
        throw new AssertionError("every Java platform has SHA", e);
      }
    }
  }
}
