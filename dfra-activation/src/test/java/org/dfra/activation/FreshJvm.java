package org.dfra.activation;

import java.lang.reflect.Field;
import java.rmi.activation.ActivationGroup;
import java.util.List;

/** Makes this JVM look as if activation had never been used: its group and system are static. */
final class FreshJvm {

  private FreshJvm() {}

  static void pretend() {
    try {
      for (String name : List.of("currentGroup", "currentID", "currentSystem")) {
        Field field = ActivationGroup.class.getDeclaredField(name);
        field.setAccessible(true);
        field.set(null, null);
      }
    } catch (ReflectiveOperationException e) {
      throw new AssertionError("ActivationGroup keeps its group and system elsewhere now", e);
    }
  }
}
