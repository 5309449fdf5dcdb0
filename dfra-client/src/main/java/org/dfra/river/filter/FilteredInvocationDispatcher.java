package org.dfra.river.filter;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.lang.reflect.Method;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import net.jini.core.constraint.MethodConstraints;
import net.jini.jeri.BasicInvocationDispatcher;
import net.jini.jeri.InboundRequest;
import net.jini.jeri.ServerCapabilities;
import org.jspecify.annotations.Nullable;

/**
 * A dispatcher that filters the arguments of every call before they are deserialized. An invocation
 * layer factory creates it in {@code createInvocationDispatcher}. Only types that the called
 * method's parameters may contain are read.
 */
public class FilteredInvocationDispatcher extends BasicInvocationDispatcher {

  private final Map<Method, MethodTypes> types = new ConcurrentHashMap<>();
  private final Map<Long, Method> numbers = new ConcurrentHashMap<>(); // of existing methods only

  /**
   * As the constructor of {@link BasicInvocationDispatcher}.
   *
   * @param methods the remote methods; the packages of their parameters are allowed too
   * @throws ExportException if the server's constraints cannot be met
   */
  public FilteredInvocationDispatcher(
      Collection<Method> methods,
      ServerCapabilities capabilities,
      @Nullable MethodConstraints server,
      @Nullable Class<?> permission,
      @Nullable ClassLoader loader)
      throws ExportException {
    super(methods, capabilities, server, permission, loader);
  }

  /**
   * The stream has its filter from the beginning; the filter is stored in the context of the call.
   */
  @Override
  @SuppressWarnings({"rawtypes", "unchecked"}) // as River declares it
  protected ObjectInputStream createMarshalInputStream(
      Object impl, InboundRequest request, boolean integrity, Collection context)
      throws IOException {
    SerialLimits limits = SerialFilters.callLimits();
    CallFilter filter = new CallFilter(limits);
    ObjectInputStream in =
        super.createMarshalInputStream(
            impl, new ScannedInboundRequest(request, limits), integrity, context);
    in.setObjectInputFilter(filter);
    context.add(filter);
    return in;
  }

  /**
   * Reads the number of the called method. A subclass may read what precedes it.
   *
   * @param context of the call
   */
  protected long readMethodNumber(ObjectInputStream in, Collection<Object> context)
      throws IOException {
    return in.readLong();
  }

  private Method method(Remote impl, long number, Collection<?> context)
      throws IOException, NoSuchMethodException, ClassNotFoundException {
    @Nullable Method known = numbers.get(number);
    if (known == null) {
      known = super.unmarshalMethod(impl, new NumberStream(number), context);
      numbers.put(number, known);
    }
    return known;
  }

  /** Narrows the filter to the method. */
  @Override
  @SuppressWarnings({"rawtypes", "unchecked"}) // as River declares it
  protected Method unmarshalMethod(Remote impl, ObjectInputStream in, Collection context)
      throws IOException, NoSuchMethodException, ClassNotFoundException {
    Method method = method(impl, readMethodNumber(in, context), context);
    for (Object element : context) {
      if (element instanceof CallFilter filter) {
        filter.narrow(types.computeIfAbsent(method, SerialFilters::argumentsOf));
      }
    }
    return method;
  }

  /** Has nothing but the number of a method: River looks it up in a table of its own. */
  private static final class NumberStream extends ObjectInputStream {

    private final long number;

    NumberStream(long number) throws IOException {
      this.number = number;
    }

    @Override
    public long readLong() {
      return number;
    }
  }

  /**
   * The filter of one call's arguments. Until the method of the call is known it allows only
   * primitive values, and afterwards the types that the method's parameters may contain.
   */
  static final class CallFilter extends ObjectGraphFilter {

    private static final AllowedTypes NO_MORE = new AllowedTypes(List.of());

    private @Nullable MethodTypes method;

    CallFilter(SerialLimits limits) {
      super(limits, NO_MORE);
    }

    /**
     * Allows the types that the parameters of the called method may contain.
     *
     * @throws IllegalStateException if the method was already set
     */
    void narrow(MethodTypes called) {
      if (method != null) {
        throw new IllegalStateException("the method of a call is read once; it was " + method);
      }
      method = called;
    }

    @Override
    void checkObject(@Nullable Class<?> type) {
      if (method == null) {
        throw new RefusedDataException(
            "refused to read "
                + (type == null ? "a reference" : "class " + type.getName())
                + " before the method that is called: a call begins with its method's number");
      }
    }

    @Override
    void check(Class<?> type) {
      if (method != null) {
        method.check(type);
      }
    }
  }
}
