package org.dfra.activation;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.io.ObjectStreamClass;
import java.util.Map;

/** Object streams in memory. */
final class Streams {

  private Streams() {}

  static byte[] write(Object object) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(object);
    }
    return bytes.toByteArray();
  }

  static Object read(byte[] bytes) throws IOException, ClassNotFoundException {
    return readAs(bytes, Map.of());
  }

  /** Reads with some classes replaced by others, by name. */
  static Object readAs(byte[] bytes, Map<String, Class<?>> classes)
      throws IOException, ClassNotFoundException {
    InputStream in = new ByteArrayInputStream(bytes);
    try (ObjectInputStream objects =
        new ObjectInputStream(in) {
          @Override
          protected Class<?> resolveClass(ObjectStreamClass written)
              throws IOException, ClassNotFoundException {
            Class<?> other = classes.get(written.getName());
            return other != null ? other : super.resolveClass(written);
          }
        }) {
      return objects.readObject();
    }
  }

  static Object roundTrip(Object object) throws IOException, ClassNotFoundException {
    return read(write(object));
  }
}
