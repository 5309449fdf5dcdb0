package org.dfra.river.filter;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.lang.reflect.Method;
import java.rmi.server.ExportException;
import java.util.Collection;
import net.jini.core.constraint.MethodConstraints;
import net.jini.jeri.BasicInvocationDispatcher;
import net.jini.jeri.InboundRequest;
import net.jini.jeri.ServerCapabilities;
import org.jspecify.annotations.Nullable;

/**
 * A dispatcher that filters the arguments of every call before they are built: what an invocation
 * layer factory makes in {@code createInvocationDispatcher}.
 */
public class FilteredInvocationDispatcher extends BasicInvocationDispatcher {

  private final AllowedTypes types;

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
    this.types = SerialFilters.argumentsOf(methods);
  }

  @Override
  @SuppressWarnings("rawtypes") // as River declares it
  protected ObjectInputStream createMarshalInputStream(
      Object impl, InboundRequest request, boolean integrity, Collection context)
      throws IOException {
    ObjectInputStream in =
        super.createMarshalInputStream(
            impl, new BoundedRequest(request, SerialFilters.callBytes()), integrity, context);
    in.setObjectInputFilter(SerialFilters.call(types));
    return in;
  }
}
