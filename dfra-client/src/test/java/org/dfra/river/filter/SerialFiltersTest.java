package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InvalidClassException;
import java.io.ObjectInputFilter;
import java.io.ObjectInputStream;
import java.io.ObjectStreamClass;
import java.lang.reflect.Field;
import java.nio.file.Path;
import java.rmi.MarshalledObject;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import javax.management.BadAttributeValueExpException;
import net.jini.io.MarshalledInstance;
import org.dfra.river.fixture.ChildJvm;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The filter of a whole virtual machine, so each test has one of its own. */
class SerialFiltersTest {

  @TempDir static Path folder;

  @BeforeAll
  static void compile() throws IOException {
    Payload.compile(folder);
  }

  @Test
  void filtersEveryStreamOfAVirtualMachine() throws Exception {
    assertThat(ChildJvm.run(Installed.class, List.of(), folder.toString())).contains("all well");
  }

  @Test
  void canBeNamedOnTheCommandLine() throws Exception {
    List<String> option =
        List.of("-Djdk.serialFilterFactory=" + SerialFilterFactory.class.getName());
    assertThat(ChildJvm.run(Installed.class, option, folder.toString())).contains("all well");
  }

  @Test
  void allowsWhatASystemPropertyAdds() throws Exception {
    assertThat(
            ChildJvm.run(
                Configured.class, List.of("-Ddfra.serial.allow=elsewhere.*"), folder.toString()))
        .contains("all well");
  }

  @Test
  void saysThatItIsTooLate() throws Exception {
    assertThat(ChildJvm.run(TooLate.class, List.of())).contains("all well");
  }

  @Test
  void saysWhichPropertyIsWrong() throws Exception {
    assertThat(ChildJvm.run(Misconfigured.class, List.of("-Ddfra.serial.bytes=many")))
        .contains("dfra.serial.bytes = \"many\" is not a whole number above 0");
  }

  /** Installs it and tries everything. */
  static final class Installed {
    public static void main(String[] args) throws Exception {
      SerialFilters.install();
      SerialFilters.install();
      assertThat(SerialFilters.isInstalled()).isTrue();
      Payload payload = new Payload(Path.of(args[0]));
      for (Map.Entry<String, Object> gadget : payload.gadgets().entrySet()) {
        MarshalledInstance instance = new MarshalledInstance(gadget.getValue());
        MarshalledObject<Object> object = new MarshalledObject<>(gadget.getValue());
        Payload.reset();
        Thread.currentThread().setContextClassLoader(payload.loader());
        refused(gadget.getKey(), () -> instance.get(payload.loader(), false, null, List.of()));
        refused(gadget.getKey(), object::get);
        assertThat(Payload.ran()).as(gadget.getKey()).isFalse();
      }
      refused("nested", () -> new MarshalledInstance(Payload.nested(100)).get(false));
      refused("bomb", () -> new MarshalledInstance(Payload.bomb(30)).get(false));
      long version = ObjectStreamClass.lookupAny(long[].class).getSerialVersionUID();
      byte[] giant = Payload.array("[J", version, 1 << 28); // 2 GiB, in a heap of 128 MiB
      refused("giant, lookup result", () -> forged(giant).get(false));
      refused("giant, plain", () -> plain(giant).readObject());
      refused("giant, stored", () -> SerialFilters.guardStored(plain(giant)).readObject());
      byte[] foreign = Payload.bytes(new BadAttributeValueExpException("x"));
      refused("foreign, plain", () -> plain(foreign).readObject());
      refused("foreign, stored", () -> SerialFilters.guardStored(plain(foreign)).readObject());

      byte[] file = Payload.bytes(new byte[8 << 20]); // more than an array from the network has
      refused("large, plain", () -> plain(file).readObject());
      assertThat(SerialFilters.guardStored(plain(file)).readObject()).isNotNull();
      assertThat(SerialFilters.<Object, Exception>readStored(() -> plain(file).readObject()))
          .isNotNull();
      refused("large, after a scope", () -> plain(file).readObject());
      byte[] answer = Payload.bytes(new byte[80 << 10]);
      assertThat(plain(answer).readObject()).isNotNull();
      refused(
          "large, an answer to discovery",
          () ->
              SerialFilters.<Object, Exception>readDiscoveryResponse(
                  () -> plain(answer).readObject()));
      refused(
          "large, marshalled in an answer",
          () -> {
            MarshalledInstance inner = forged(answer);
            return SerialFilters.<Object, Exception>readDiscoveryResponse(() -> inner.get(false));
          });
      Object afterInner =
          SerialFilters.<Object, Exception>readStored(
              () -> {
                refused(
                    "large, an answer within a file",
                    () ->
                        SerialFilters.<Object, Exception>readDiscoveryResponse(
                            () -> plain(answer).readObject()));
                return plain(file).readObject(); // the outer scope again
              });
      assertThat(afterInner).isNotNull();

      Object registrations = new ArrayList<>(Collections.nCopies(300_000, 1.5));
      assertThat(plain(Payload.bytes(registrations)).readObject()).isEqualTo(registrations);
      List<Object> journal = new ArrayList<>();
      for (int i = 0; i < 300_000; i++) {
        journal.add(new MarshalledInstance[0]);
      }
      assertThat((List<?>) plain(Payload.bytes(journal)).readObject()).hasSize(300_000);
      assertThat(new MarshalledInstance(List.of("fix", 1.5)).get(false))
          .isEqualTo(List.of("fix", 1.5));

      ObjectInputStream narrowed = plain(Payload.bytes(List.of("a")));
      narrowed.setObjectInputFilter(ObjectInputFilter.Config.createFilter("!*"));
      assertThatThrownBy(narrowed::readObject).isInstanceOf(InvalidClassException.class);
      ObjectInputStream widened = plain(Payload.bytes(new BadAttributeValueExpException("x")));
      widened.setObjectInputFilter(ObjectInputFilter.Config.createFilter("*"));
      refused("widened", widened::readObject);
      System.out.println("all well");
    }

    private static ObjectInputStream plain(byte[] bytes) throws IOException {
      return new ObjectInputStream(new ByteArrayInputStream(bytes));
    }

    /** A marshalled instance as a stranger may have written it. */
    private static MarshalledInstance forged(byte[] bytes) throws Exception {
      MarshalledInstance instance = new MarshalledInstance("x");
      Field objects = MarshalledInstance.class.getDeclaredField("objBytes");
      objects.setAccessible(true);
      objects.set(instance, bytes);
      return instance;
    }

    private interface Reading {
      Object read() throws Exception;
    }

    private static void refused(String what, Reading reading) {
      assertThatThrownBy(reading::read)
          .as(what)
          .hasStackTraceContaining(RefusedDataException.class.getName() + ": refused to read");
    }
  }

  /** With the payload's package allowed. */
  static final class Configured {
    public static void main(String[] args) throws Exception {
      SerialFilters.install();
      Payload payload = new Payload(Path.of(args[0]));
      MarshalledInstance instance = new MarshalledInstance(payload.object());
      assertThat(instance.get(payload.loader(), false, null, List.of())).isNotNull();
      System.out.println("all well");
    }
  }

  /** Installs it after a stream was read. */
  static final class TooLate {
    public static void main(String[] args) throws Exception {
      new ObjectInputStream(new ByteArrayInputStream(Payload.bytes("x"))).readObject();
      assertThatThrownBy(SerialFilters::install)
          .isInstanceOf(IllegalStateException.class)
          .hasMessageContaining("call SerialFilters.install() first in main");
      System.out.println("all well");
    }
  }

  /** With a property that makes no sense. */
  static final class Misconfigured {
    public static void main(String[] args) {
      try {
        SerialFilters.install();
      } catch (IllegalArgumentException e) {
        System.out.println(e.getMessage());
      }
    }
  }
}
