package org.dfra.river.server;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.lang.invoke.MethodType;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.rmi.Remote;
import java.rmi.server.RemoteObjectInvocationHandler;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import org.jspecify.annotations.Nullable;

/**
 * Makes calls by the stub's reference. Method numbers (hashes) follow the RMI specification,
 * section 8.3.
 *
 * @param stub the JDK's stub
 */
record JrmpInvocationHandler(Remote stub) implements InvocationHandler, Serializable {

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
        MethodType.methodType(method.getReturnType(), method.getParameterTypes())
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
