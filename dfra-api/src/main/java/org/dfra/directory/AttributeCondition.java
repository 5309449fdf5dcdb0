package org.dfra.directory;

import java.lang.reflect.RecordComponent;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dfra.persona.Attributes;
import org.jspecify.annotations.Nullable;

/**
 * A condition on one component of one kind of attributes.
 *
 * @param reader reads the component
 */
record AttributeCondition(
    Class<? extends Attributes> type,
    String component,
    Function<Attributes, @Nullable Object> reader,
    Condition condition) {

  /**
   * @throws IllegalArgumentException if the record has no such component, or its type does not fit
   *     the condition
   */
  static AttributeCondition of(
      Class<? extends Attributes> type, String component, Condition condition) {
    RecordComponent[] components = type.getRecordComponents();
    if (components == null) {
      throw new IllegalArgumentException(
          type.getName() + " is not a record; name a record of attributes");
    }
    RecordComponent found =
        Arrays.stream(components)
            .filter(each -> each.getName().equals(component))
            .findFirst()
            .orElseThrow(() -> new IllegalArgumentException(unknown(type, component)));
    String complaint = condition.validationError(found.getType());
    if (complaint != null) {
      throw new IllegalArgumentException(type.getSimpleName() + "." + component + " " + complaint);
    }
    return new AttributeCondition(type, component, ComponentReaders.of(type, component), condition);
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
  boolean test(List<Attributes> attributes) {
    for (int i = 0; i < attributes.size(); i++) { // ten thousand lists per query: no iterators
      Attributes each = attributes.get(i);
      if (each.getClass() == type) {
        return condition.test(reader.apply(each));
      }
    }
    return false;
  }

  /** The reader is derived from the other components. */
  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof AttributeCondition that
        && type == that.type
        && component.equals(that.component)
        && condition.equals(that.condition);
  }

  @Override
  public int hashCode() {
    return Objects.hash(type, component, condition);
  }

  @Override
  public String toString() {
    return type.getSimpleName() + "." + component + " " + condition;
  }
}
