package org.dfra.directory;

import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.stream.Collectors;
import org.dfra.persona.Attributes;

/**
 * A condition on one component of one kind of attributes.
 *
 * @param accessor reads the component
 */
record AttributeTest(Class<? extends Attributes> type, Method accessor, Condition condition) {

  /**
   * @throws IllegalArgumentException if the record has no such component, or its type does not fit
   *     the condition
   */
  static AttributeTest of(Class<? extends Attributes> type, String component, Condition condition) {
    RecordComponent[] components = type.getRecordComponents();
    if (components == null) {
      throw new IllegalArgumentException(
          type.getName() + " is no record; name a record of attributes");
    }
    RecordComponent found =
        Arrays.stream(components)
            .filter(each -> each.getName().equals(component))
            .findFirst()
            .orElseThrow(() -> new IllegalArgumentException(unknown(type, component)));
    String complaint = condition.complaint(found.getType());
    if (complaint != null) {
      throw new IllegalArgumentException(type.getSimpleName() + "." + component + " " + complaint);
    }
    Method accessor = found.getAccessor();
    accessor.setAccessible(true);
    return new AttributeTest(type, accessor, condition);
  }

  private static String unknown(Class<?> type, String component) {
    return type.getSimpleName()
        + " has no component \""
        + component
        + "\"; it has "
        + Arrays.stream(type.getRecordComponents())
            .map(RecordComponent::getName)
            .collect(Collectors.joining(", "));
  }

  /** Whether one of the records meets the condition. */
  boolean test(Iterable<Attributes> attributes) {
    for (Attributes each : attributes) {
      if (each.getClass() == type) {
        try {
          return condition.test(accessor.invoke(each));
        } catch (ReflectiveOperationException e) {
          throw new IllegalStateException(this + " cannot be read", e);
        }
      }
    }
    return false;
  }

  @Override
  public String toString() {
    return type.getSimpleName() + "." + accessor.getName() + " " + condition;
  }
}
