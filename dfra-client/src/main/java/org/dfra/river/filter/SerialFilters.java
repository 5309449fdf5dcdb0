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
 * allows references to objects exported by JRMP, for programs that use them. They are read once.
 */
public final class SerialFilters {

  /**
   * An action that reads object streams.
   *
   * @param <T> its result
   * @param <E> its exception if reading fails
   */
  @FunctionalInterface
  public interface ReadAction<T extends @Nullable Object, E extends Exception> {

    /** Reads. */
    T read() throws E;
  }

  /** Opens the object stream that reads a request's response, as JERI's invocation handlers do. */
  @FunctionalInterface
  public interface StreamOpener {

    /**
     * Opens the stream.
     *
     * @param request whose response is to be read
     */
    ObjectInputStream open(OutboundRequest request) throws IOException;
  }

  /** The limits of the current thread's streams; empty for the network. */
  private static final ThreadLocal<@Nullable SerialLimits> SCOPE = new ThreadLocal<>();

  private SerialFilters() {}

  /**
   * The options that give another virtual machine of DFRA the same filters: a child inherits none.
   */
  public static List<String> options() {
    return System.getProperties().stringPropertyNames().stream()
        .filter(name -> name.startsWith("dfra.serial."))
        .sorted()
        .map(name -> "-D" + name + "=" + System.getProperty(name))
        .toList();
  }

  /** The configuration; read at first use, so that a main can set it before. */
  private static final class ConfiguredFilters {
    static final AllowedTypes TYPES =
        AllowedTypes.parse(System.getProperty("dfra.serial.allow", ""), flag("dfra.serial.jrmp"));
    static final SerialLimits CALL = SerialLimits.CALL.with(System.getProperties());
    static final SerialLimits STREAM = SerialLimits.STREAM.with(System.getProperties());

    /** By the method's return type, whose package is allowed too. */
    static final ClassValue<AllowedTypes> RESULTS =
        new ClassValue<>() {
          @Override
          protected AllowedTypes computeValue(Class<?> result) {
            return TYPES.with(List.of(result));
          }
        };

    private static boolean flag(String key) {
      String text = System.getProperty(key, "false").trim();
      if (!text.equals("true") && !text.equals("false")) {
        throw new IllegalArgumentException(
            key + " = \"" + text + "\" is neither true nor false; correct the system property");
      }
      return text.equals("true");
    }
  }

  /**
   * Filters every object stream that this virtual machine reads from now on. Call it in the first
   * line of a main: after the first stream, the JDK accepts no filter factory any more. Does
   * nothing the second time.
   *
   * @throws IllegalStateException if it is too late or another factory is installed
   * @throws IllegalArgumentException if a {@code dfra.serial} property is invalid
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
   * Opens the object stream of a call's result: its bytes are checked before anything is
   * deserialized, and it has the filter of the method.
   *
   * @param request the call
   * @param method the method called; the package of its result is allowed too
   * @param opening opens the stream that reads the response to the request
   * @throws IOException as {@code opening} does
   */
  public static ObjectInputStream openResult(
      OutboundRequest request, Method method, StreamOpener opening) throws IOException {
    return openResult(request, method, resultLimits(), opening);
  }

  /**
   * As {@link #openResult(OutboundRequest, Method, StreamOpener)}, with other limits.
   *
   * @param limits maximum size of the result
   */
  public static ObjectInputStream openResult(
      OutboundRequest request, Method method, SerialLimits limits, StreamOpener opening)
      throws IOException {
    ObjectInputStream in = opening.open(new ScannedOutboundRequest(request, limits));
    in.setObjectInputFilter(
        new ObjectGraphFilter(limits, ConfiguredFilters.RESULTS.get(method.getReturnType())));
    return in;
  }

  /** The default limits of a call's result. */
  public static SerialLimits resultLimits() {
    return ConfiguredFilters.STREAM;
  }

  /**
   * Returns the same bytes, checked like those of a call's response: each complete element of the
   * object stream before it is passed on.
   *
   * @param in an object stream from its first byte; read in small pieces, so it should be buffered
   */
  public static InputStream checked(InputStream in) {
    return ScannedStream.of(in, ConfiguredFilters.STREAM);
  }

  /**
   * Applies the limits of a file that this computer wrote itself, such as a journal.
   *
   * @param in a stream that nothing was read from
   */
  public static ObjectInputStream guardStored(ObjectInputStream in) {
    in.setObjectInputFilter(new ObjectGraphFilter(SerialLimits.STORED, ConfiguredFilters.TYPES));
    return in;
  }

  /**
   * Checks the contents of a marshalled object before it is unmarshalled, with the limits of a
   * stream that the current thread would open now. Marshalled objects in calls and in their results
   * were already checked on arrival.
   *
   * @param marshalled a {@code MarshalledObject} or {@code MarshalledInstance}
   * @throws RefusedDataException if it may not be unmarshalled
   * @throws IOException if it cannot be unmarshalled
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

  /** The limits of the arguments of one call. */
  static SerialLimits callLimits() {
    return ConfiguredFilters.CALL;
  }

  /** The types that the arguments of a method may contain. */
  static MethodTypes argumentsOf(Method method) {
    return MethodTypes.of(method, ConfiguredFilters.TYPES);
  }

  static ObjectInputFilter newCallFilter(AllowedTypes types) {
    return new ObjectGraphFilter(ConfiguredFilters.CALL, types);
  }

  /**
   * A filter for a stream that the current thread opens now: with the network's limits, unless its
   * scope has others.
   */
  static ObjectGraphFilter newStreamFilter() {
    return new ObjectGraphFilter(scope(), ConfiguredFilters.TYPES);
  }

  /**
   * Reads with the limits of data that this computer wrote itself: object streams that the current
   * thread opens meanwhile may be as large as a file. For code that opens its own streams, such as
   * a lookup service that recovers from its log.
   *
   * @param reading the action; none of its data may come from the network
   * @throws E as {@code reading} does
   */
  public static <T extends @Nullable Object, E extends Exception> T readStored(
      ReadAction<T, E> reading) throws E {
    return within(SerialLimits.STORED, reading);
  }

  /**
   * Reads a response of unicast discovery: object streams that the current thread opens meanwhile
   * have the limits {@link SerialLimits#DISCOVERY_RESPONSE}.
   *
   * @throws E as {@code reading} does
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
