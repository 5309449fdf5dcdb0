package org.dfra.benchmarks.micro;

import java.io.IOException;
import java.io.ObjectInputStream;
import java.lang.reflect.Method;
import java.rmi.Remote;
import java.rmi.server.ExportException;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.dfra.river.filter.FilteredInvocationDispatcher;

/**
 * The receiving end of calls, without transport: it checks and reads the arguments as an exported
 * object's dispatcher does, but calls nothing.
 */
final class ArgumentReader extends FilteredInvocationDispatcher {

  private final Remote callee;

  /**
   * @param method the only method that may be called
   * @param callee an object that has it
   * @throws ExportException if it cannot be exported
   */
  ArgumentReader(Method method, Remote callee) throws ExportException {
    super(
        List.of(method),
        constraints -> constraints,
        null,
        null,
        ArgumentReader.class.getClassLoader());
    this.callee = callee;
  }

  /**
   * Reads the arguments of a call.
   *
   * @param request its bytes
   * @param from index of the first byte of their object stream
   * @throws IOException if they are refused, or cannot be read
   */
  Object[] read(byte[] request, int from) throws IOException, ReflectiveOperationException {
    Collection<Object> context = new ArrayList<>();
    try (ObjectInputStream in =
        createMarshalInputStream(callee, new RecordedRequest(request, from), false, context)) {
      Method method = unmarshalMethod(callee, in, context);
      return unmarshalArguments(callee, method, in, context);
    }
  }
}
