package org.dfra.river.registrar;

import java.lang.reflect.Field;
import org.jspecify.annotations.Nullable;

/** Access to the fields of reggie 2.2.2, which has no method to read its contents. */
public final class ReggieFields {

  private static final String CLASS = "com.sun.jini.reggie.RegistrarImpl";

  private ReggieFields() {}

  /**
   * The class that declares reggie's fields.
   *
   * @param reggie the lookup service
   * @throws NoSuchFieldException if it is not reggie
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

  /** The value of a field from {@link #accessible}. */
  static @Nullable Object value(Field field, Object of) {
    try {
      return field.get(of);
    } catch (IllegalAccessException e) {
      throw new AssertionError(e); // it was made accessible
    }
  }

  /** The value of an integer field from {@link #accessible}. */
  static long number(Field field, Object of) {
    try {
      return field.getLong(of);
    } catch (IllegalAccessException e) {
      throw new AssertionError(e); // it was made accessible
    }
  }
}
