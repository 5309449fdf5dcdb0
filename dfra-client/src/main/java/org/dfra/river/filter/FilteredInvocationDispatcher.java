package org.dfra.river.filter;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.lang.reflect.Method;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.util.Collection;
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

  /** Narrows the filter to the method. */
  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  protected Method unmarshalMethod(Remote impl, ObjectInputStream in, Collection context)
      throws IOException, NoSuchMethodException, ClassNotFoundException {
    Method method = super.unmarshalMethod(impl, in, context);
    for (Object element : context) {
      if (element instanceof CallFilter filter) {
        filter.narrow(types.computeIfAbsent(method, SerialFilters::argumentsOf));
      }
    }
    return method;
  }
}
