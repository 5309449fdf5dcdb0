package org.dfra.river.registrar;

import java.lang.reflect.Field;
import org.jspecify.annotations.Nullable;

/** Fields of reggie 2.2.2, which offers no other way to what it holds. */
public final class ReggieFields {

  private static final String CLASS = "com.sun.jini.reggie.RegistrarImpl";

  private ReggieFields() {}

  /**
   * The class that has reggie's fields.
   *
   * @param reggie the lookup service
   * @throws NoSuchFieldException if it is no reggie
   */
  public static Class<?> owner(Object reggie) throws NoSuchFieldException {
    Class<?> type = reggie.getClass();
    while (type != null && !type.getName().equals(CLASS)) {
      type = type.getSuperclass();
    }
    if (type == null) {
      throw new NoSuchFieldException(reggie.getClass().getName() + " is no " + CLASS);
    }
    return type;
  }

  /** A field of a class, whatever its access. */
  public static Field accessible(Class<?> type, String name) throws NoSuchFieldException {
    Field field = type.getDeclaredField(name);
    field.setAccessible(true);
    return field;
  }

  /** What a field that {@link #accessible} gave holds. */
  static @Nullable Object value(Field field, Object of) {
    try {
      return field.get(of);
    } catch (IllegalAccessException e) {
      throw new AssertionError(e); // it was made accessible
    }
  }

  /** The same of a field that holds a whole number. */
  static long number(Field field, Object of) {
    try {
      return field.getLong(of);
    } catch (IllegalAccessException e) {
      throw new AssertionError(e); // it was made accessible
    }
  }
}
