package org.dfra.river.filter;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * The filter of one call's arguments. Until the method of the call is known it allows only
 * primitive values, and afterwards the types that the method's parameters may contain.
 */
final class CallFilter extends ObjectGraphFilter {

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
