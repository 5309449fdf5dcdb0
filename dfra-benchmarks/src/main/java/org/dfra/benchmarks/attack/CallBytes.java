package org.dfra.benchmarks.attack;

import com.sun.jini.jeri.internal.runtime.Util;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectOutputStream;
import java.lang.reflect.Method;
import java.util.List;
import net.jini.io.MarshalOutputStream;
import org.jspecify.annotations.Nullable;

/**
 * The bytes of a call as JERI's invocation layer sends them:
 *
 * <pre>
 *   00         version of the protocol
 *   00         no integrity required
 *   ac ed ...  an object stream: the method's hash, then its arguments
 * </pre>
 */
public final class CallBytes {

  /** The protocol version, without integrity. */
  private static final byte[] OPENING = {0, 0};

  private CallBytes() {}

  /** Writes the arguments of a call. */
  @FunctionalInterface
  public interface Arguments {
    /**
     * Writes the arguments, valid or not.
     *
     * @param out stream after the method's hash; it annotates classes as River does
     * @throws IOException if they cannot be written
     */
    void write(ObjectOutputStream out) throws IOException;
  }

  /**
   * A valid call.
   *
   * @param arguments one for each of the method's parameters
   * @throws IOException if one of them cannot be written
   */
  public static byte[] of(Method method, @Nullable Object... arguments) throws IOException {
    Class<?>[] types = method.getParameterTypes();
    if (arguments.length != types.length) {
      throw new IllegalArgumentException(
          method + " has " + types.length + " parameters, not " + arguments.length);
    }
    return with(
        method,
        out -> {
          for (int i = 0; i < types.length; i++) {
            Util.marshalValue(types[i], arguments[i], out);
          }
        });
  }

  /**
   * A call with arguments that need not match the method.
   *
   * @throws IOException if they cannot be written
   */
  public static byte[] with(Method method, Arguments arguments) throws IOException {
    return with(Util.getMethodHash(method), arguments);
  }

  /**
   * A call with any method hash.
   *
   * @param hash the method's hash
   * @throws IOException if the arguments cannot be written
   */
  public static byte[] with(long hash, Arguments arguments) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.write(OPENING);
    try (ObjectOutputStream out = new MarshalOutputStream(bytes, List.of())) {
      out.writeLong(hash);
      arguments.write(out);
    }
    return bytes.toByteArray();
  }
}
