package org.dfra.river.filter;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputFilter;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.Serializable;
import java.lang.reflect.Method;
import java.util.List;
import net.jini.jeri.OutboundRequest;
import org.jspecify.annotations.Nullable;

/**
 * The deserialization filters of this virtual machine.
 *
 * <p>System properties: {@code dfra.serial.allow} lists further classes and packages, and {@code
 * dfra.serial.depth}, {@code .references}, {@code .bytes}, {@code .array}, {@code .heap} and {@code
 * .table} replace limits for everything that comes from the network. {@code dfra.serial.jrmp=true}
 * allows references to objects exported by JRMP, for programs that use any. They are read once.
 */
public final class SerialFilters {

  /**
   * Something that reads object streams.
   *
   * @param <T> what was read
   * @param <E> what it throws if it cannot be read
   */
  @FunctionalInterface
  public interface ReadAction<T extends @Nullable Object, E extends Exception> {

    /** Reads. */
    T read() throws E;
  }

  /** Makes the object stream that reads a request's answer, as JERI's invocation handlers do. */
  @FunctionalInterface
  public interface StreamOpener {

    /**
     * Makes it.
     *
     * @param request whose answer is to be read
     */
    ObjectInputStream open(OutboundRequest request) throws IOException;
  }

  /** What the current thread's streams read from; empty for the network. */
  private static final ThreadLocal<@Nullable SerialLimits> SCOPE = new ThreadLocal<>();

  private SerialFilters() {}

  /**
   * The options with which another virtual machine of DFRA filters alike: a child inherits none.
   */
  public static List<String> options() {
    return System.getProperties().stringPropertyNames().stream()
        .filter(name -> name.startsWith("dfra.serial."))
        .sorted()
        .map(name -> "-D" + name + "=" + System.getProperty(name))
        .toList();
  }

  /** What is configured; read when it is first needed, so that a main can set it before. */
  private static final class ConfiguredFilters {
    static final AllowedTypes TYPES =
        AllowedTypes.parse(System.getProperty("dfra.serial.allow", ""), flag("dfra.serial.jrmp"));
    static final SerialLimits CALL = SerialLimits.CALL.with(System.getProperties());
    static final SerialLimits STREAM = SerialLimits.STREAM.with(System.getProperties());

    private static boolean flag(String key) {
      String text = System.getProperty(key, "false").trim();
      if (!text.equals("true") && !text.equals("false")) {
        throw new IllegalArgumentException(
            key + " = \"" + text + "\" is neither true nor false; mend the system property");
      }
      return text.equals("true");
    }
  }

  /**
   * Filters every object stream that this virtual machine reads from now on. The first line of a
   * main: once a stream was read, the JDK takes no filter factory any more. Doing it again does
   * nothing.
   *
   * @throws IllegalStateException if it is too late or another factory is in place
   * @throws IllegalArgumentException if a {@code dfra.serial} property makes no sense
   */
  public static synchronized void install() {
    checkConfiguration();
    try {
      ObjectInputFilter.Config.setSerialFilterFactory(new SerialFilterFactory());
    } catch (IllegalStateException e) {
      if (!isInstalled()) {
        throw new IllegalStateException(
            "deserialization filters cannot be put in place any more: an object stream was read or"
                + " another filter factory was set before; call SerialFilters.install() first in"
                + " main",
            e);
      }
    }
  }

  private static void checkConfiguration() {
    try {
      ConfiguredFilters.TYPES.with(List.of());
    } catch (ExceptionInInitializerError e) {
      if (e.getCause() instanceof IllegalArgumentException wrong) {
        throw wrong;
      }
      throw e;
    }
  }

  /** Whether every object stream of this virtual machine is filtered. */
  public static boolean isInstalled() {
    return ObjectInputFilter.Config.getSerialFilterFactory() instanceof SerialFilterFactory;
  }

  /**
   * Opens the object stream that the result of a call is read from: its bytes are checked before
   * anything of them is built, and its filter is that of the method.
   *
   * @param request the call
   * @param method the method called; the package of its result is allowed too
   * @param opening makes the stream that reads the answer of the request that it is given
   * @throws IOException what {@code opening} throws
   */
  public static ObjectInputStream openResult(
      OutboundRequest request, Method method, StreamOpener opening) throws IOException {
    return openResult(request, method, resultLimits(), opening);
  }

  /**
   * The same.
   *
   * @param limits how large the result may be
   */
  public static ObjectInputStream openResult(
      OutboundRequest request, Method method, SerialLimits limits, StreamOpener opening)
      throws IOException {
    ObjectInputStream in = opening.open(new ScannedOutboundRequest(request, limits));
    in.setObjectInputFilter(
        new ObjectGraphFilter(
            limits, ConfiguredFilters.TYPES.with(List.of(method.getReturnType()))));
    return in;
  }

  /** How large the result of a call may be where nothing else is said. */
  public static SerialLimits resultLimits() {
    return ConfiguredFilters.STREAM;
  }

  /**
   * The same bytes, checked as those of a call's answer are: each element of the object stream as a
   * whole, before it is passed on.
   *
   * @param in an object stream from its first byte
   */
  public static InputStream checked(InputStream in) {
    return ScannedStream.of(in, ConfiguredFilters.STREAM);
  }

  /**
   * Reads a file: what this computer wrote itself, such as a journal.
   *
   * @param in a stream that nothing was read from
   */
  public static ObjectInputStream guardStored(ObjectInputStream in) {
    in.setObjectInputFilter(new ObjectGraphFilter(SerialLimits.STORED, ConfiguredFilters.TYPES));
    return in;
  }

  /**
   * Checks what a marshalled object holds before it is unpacked, with the limits of a stream that
   * the current thread would make now. Those in calls and in their results were checked as they
   * came.
   *
   * @param marshalled a {@code MarshalledObject} or {@code MarshalledInstance}
   * @throws RefusedDataException if it may not be unpacked
   * @throws IOException if it cannot be
   */
  public static void check(Serializable marshalled) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(marshalled);
    }
    StreamScanner scanner =
        new StreamScanner(new ByteArrayInputStream(bytes.toByteArray()), scope());
    boolean goesOn = true;
    while (goesOn) {
      goesOn = scanner.next();
    }
  }

  private static SerialLimits scope() {
    @Nullable SerialLimits scope = SCOPE.get();
    return scope == null ? ConfiguredFilters.STREAM : scope;
  }

  /** How large the arguments of one call may be. */
  static SerialLimits callLimits() {
    return ConfiguredFilters.CALL;
  }

  /** What the arguments of a method may hold. */
  static MethodTypes argumentsOf(Method method) {
    return MethodTypes.of(method, ConfiguredFilters.TYPES);
  }

  static ObjectInputFilter newCallFilter(AllowedTypes types) {
    return new ObjectGraphFilter(ConfiguredFilters.CALL, types);
  }

  /** For a stream that the current thread makes now: the network's, unless its scope is another. */
  static ObjectGraphFilter newStreamFilter() {
    return new ObjectGraphFilter(scope(), ConfiguredFilters.TYPES);
  }

  /**
   * Reads with the limits of what this computer wrote itself: object streams that the current
   * thread makes meanwhile may be as large as a file. For code that makes its streams itself, such
   * as a lookup service that recovers from its log.
   *
   * @param reading what reads; nothing of it may come from the network
   * @throws E what {@code reading} throws
   */
  public static <T extends @Nullable Object, E extends Exception> T readStored(
      ReadAction<T, E> reading) throws E {
    return within(SerialLimits.STORED, reading);
  }

  /**
   * Reads an answer to unicast discovery: object streams that the current thread makes meanwhile
   * have the limits {@link SerialLimits#DISCOVERY_RESPONSE}.
   *
   * @throws E what {@code reading} throws
   */
  public static <T extends @Nullable Object, E extends Exception> T readDiscoveryResponse(
      ReadAction<T, E> reading) throws E {
    return within(SerialLimits.DISCOVERY_RESPONSE, reading);
  }

  private static <T extends @Nullable Object, E extends Exception> T within(
      SerialLimits limits, ReadAction<T, E> reading) throws E {
    SerialLimits outer = SCOPE.get();
    SCOPE.set(limits);
    try {
      return reading.read();
    } finally {
      if (outer == null) {
        SCOPE.remove();
      } else {
        SCOPE.set(outer);
      }
    }
  }
}
