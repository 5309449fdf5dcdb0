package org.dfra.directory;

import java.lang.invoke.LambdaMetafactory;
import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.Function;
import org.dfra.persona.Attributes;
import org.jspecify.annotations.Nullable;

/** Reads components of attribute records as fast as direct accessor calls. */
final class ComponentReaders {

  private static final ClassValue<Map<String, Function<Attributes, @Nullable Object>>> READERS =
      new ClassValue<>() {
        @Override
        protected Map<String, Function<Attributes, @Nullable Object>> computeValue(Class<?> type) {
          Map<String, Function<Attributes, @Nullable Object>> readers = new HashMap<>();
          for (RecordComponent each : type.getRecordComponents()) {
            readers.put(each.getName(), reader(type, each.getAccessor()));
          }
          return readers;
        }
      };

  private ComponentReaders() {}

  /** Reads one component, which the record has. */
  static Function<Attributes, @Nullable Object> of(Class<?> type, String component) {
    return Objects.requireNonNull(READERS.get(type).get(component));
  }

  @SuppressWarnings("unchecked") // the lambda is created with these types
  private static Function<Attributes, @Nullable Object> reader(Class<?> type, Method accessor) {
    try {
      MethodHandles.Lookup lookup = MethodHandles.privateLookupIn(type, MethodHandles.lookup());
      MethodHandle handle = lookup.unreflect(accessor);
      return (Function<Attributes, @Nullable Object>)
          LambdaMetafactory.metafactory(
                  lookup,
                  "apply",
                  MethodType.methodType(Function.class),
                  MethodType.methodType(Object.class, Object.class),
                  handle,
                  handle.type().wrap())
              .getTarget()
              .invoke();
    } catch (Error e) {
      throw e;
    } catch (Throwable e) { // as MethodHandle.invoke declares it
      throw new IllegalArgumentException(
          type.getName() + " cannot be read; make the record public and its package open", e);
    }
  }
}
