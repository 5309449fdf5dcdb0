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
 * A dispatcher that filters the arguments of every call before they are built: what an invocation
 * layer factory makes in {@code createInvocationDispatcher}. Only what the called method's own
 * parameters may hold is read.
 */
public class FilteredInvocationDispatcher extends BasicInvocationDispatcher {

  private final Map<Method, MethodTypes> types = new ConcurrentHashMap<>();

  /**
   * As {@link BasicInvocationDispatcher} has it.
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

  /** The stream has its filter from the beginning; the context of the call keeps it. */
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
