package org.dfra.core.audit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.core.audit.AuditFixture.settings;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import org.dfra.core.audit.VerifiedStream.Break;
import org.dfra.core.audit.VerifiedStream.Kind;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Every change of a trail is found, each at its line. */
class BrokenTrailTest {

  private static final long SEED = 2004;
  private static final int BITS = 150;

  @TempDir static Path temp;

  private static Path folder;
  private static TestMember robot;
  private static KeptHead head;

  /** The lines of each file, each with its end. */
  private static final List<List<byte[]>> FILES = new ArrayList<>();

  @BeforeAll
  static void write() throws Exception {
    robot = TestMember.create(temp, "robot", "atrv1");
    folder = temp.resolve("audit");
    AuditHead signed = AuditFixture.write(settings(folder, "gps"), 28, robot);
    head = KeptHead.of(signed, robot.certificate());
    // the trail's second close has added a line after the head: the mutated trails end at the head
    for (TrailFile each : TrailFile.in(folder, "gps")) {
      FILES.add(lines(Files.readAllBytes(each.path())));
    }
    List<byte[]> last = FILES.get(FILES.size() - 1);
    last.remove(last.size() - 1);
    restore(FILES);
    assertThat(FILES).hasSize(3);
    assertThat(verify()).isEmpty();
  }

  private static List<byte[]> lines(byte[] bytes) {
    List<byte[]> lines = new ArrayList<>();
    ByteArrayOutputStream line = new ByteArrayOutputStream();
    for (byte each : bytes) {
      line.write(each);
      if (each == '\n') {
        lines.add(line.toByteArray());
        line.reset();
      }
    }
    return lines;
  }

  private static List<List<byte[]>> copy() {
    List<List<byte[]>> copy = new ArrayList<>();
    FILES.forEach(each -> copy.add(new ArrayList<>(each)));
    return copy;
  }

  private static void restore(List<List<byte[]>> files) throws IOException {
    for (int i = 0; i < files.size(); i++) {
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      files.get(i).forEach(bytes::writeBytes);
      Files.write(TrailFile.of(folder, "gps", i + 1).path(), bytes.toByteArray());
    }
  }

  private static List<Break> verify() throws IOException {
    return AuditVerifier.verify(folder, List.of(head)).stream()
        .flatMap(each -> each.broken().stream())
        .toList();
  }

  private static Break verify(List<List<byte[]>> files) throws IOException {
    restore(files);
    List<Break> found = verify();
    assertThat(found).hasSize(1);
    return found.get(0);
  }

  /** Whether a break is at a line (from 0) of a file (from 0), or beside it. */
  private static void assertNear(Break found, int file, int line) {
    long before = FILES.subList(0, file).stream().mapToLong(List::size).sum() + line;
    int in = Integer.parseInt(found.file().getFileName().toString().split("\\.", -1)[1]) - 1;
    long at = FILES.subList(0, in).stream().mapToLong(List::size).sum() + found.line() - 1;
    assertThat(Math.abs(at - before))
        .as("line %s of file %s was changed, found: %s", line + 1, file + 1, found)
        .isLessThanOrEqualTo(1);
  }

  @Test
  void everyChangedLineIsFound() throws Exception {
    for (int file = 0; file < FILES.size(); file++) {
      for (int line = 0; line < FILES.get(file).size(); line++) {
        List<List<byte[]>> files = copy();
        String text = new String(files.get(file).get(line), StandardCharsets.UTF_8);
        String other = text.replaceFirst("21:00:00", "21:00:01");
        assertThat(other).isNotEqualTo(text);
        files.get(file).set(line, other.getBytes(StandardCharsets.UTF_8));
        Break found = verify(files);
        assertThat(found.kind()).as(found.toString()).isEqualTo(Kind.CHANGED);
        assertNear(found, file, line);
      }
    }
  }

  @Test
  void everyRemovedLineIsFound() throws Exception {
    for (int file = 0; file < FILES.size(); file++) {
      for (int line = 0; line < FILES.get(file).size(); line++) {
        List<List<byte[]>> files = copy();
        files.get(file).remove(line);
        Break found = verify(files);
        boolean isLast = file == FILES.size() - 1 && line == FILES.get(file).size() - 1;
        assertThat(found.kind()).as(found.toString()).isEqualTo(isLast ? Kind.CUT : Kind.MISSING);
        assertNear(found, file, line);
      }
    }
  }

  @Test
  void everySwapOfNeighboursAndEveryCopyIsFound() throws Exception {
    for (int file = 0; file < FILES.size(); file++) {
      for (int line = 0; line + 1 < FILES.get(file).size(); line++) {
        List<List<byte[]>> files = copy();
        Collections.swap(files.get(file), line, line + 1);
        assertNear(verify(files), file, line);
        files = copy();
        files.get(file).add(line, files.get(file).get(line));
        Break found = verify(files);
        assertThat(found.kind()).as(found.toString()).isEqualTo(Kind.OUT_OF_ORDER);
        assertNear(found, file, line);
      }
    }
  }

  @Test
  void everyCutIsFound() throws Exception {
    for (int file = 0; file < FILES.size(); file++) {
      for (int line = file == 0 ? 1 : 0; line < FILES.get(file).size(); line++) {
        for (boolean isWithin : new boolean[] {false, true}) {
          List<List<byte[]>> files = copy();
          List<byte[]> cut = files.get(file);
          byte[] first = cut.get(line);
          cut.subList(line, cut.size()).clear();
          if (isWithin) {
            cut.add(Arrays.copyOf(first, first.length / 2));
          }
          files.subList(file + 1, files.size()).forEach(List::clear);
          Break found = verify(files);
          assertThat(found.kind()).as(found.toString()).isEqualTo(Kind.CUT);
        }
      }
    }
  }

  @Test
  void everyRemovedFileIsFound() throws Exception {
    for (int file = 1; file <= FILES.size(); file++) {
      restore(FILES);
      Files.delete(TrailFile.of(folder, "gps", file).path());
      assertThat(verify()).as("without file %s", file).hasSize(1);
    }
    for (int file = 1; file < FILES.size(); file++) {
      Files.deleteIfExists(TrailFile.of(folder, "gps", file).path());
    }
    assertThatThrownBy(BrokenTrailTest::verify)
        .as("without all files")
        .hasMessageContaining("none of the heads is of");
  }

  @Test
  void bitsAreFound() throws Exception {
    Random random = new Random(SEED);
    for (int i = 0; i < BITS; i++) {
      List<List<byte[]>> files = copy();
      int file = random.nextInt(files.size());
      int line = random.nextInt(files.get(file).size());
      byte[] changed = files.get(file).get(line).clone();
      int at = random.nextInt(changed.length);
      changed[at] ^= (byte) (1 << random.nextInt(8));
      files.get(file).set(line, changed);
      assertNear(verify(files), file, line);
    }
  }

  /** The chain alone cannot show it, which the reference says. */
  @Test
  void aCutBetweenLinesIsOnlyFoundByAHead() throws Exception {
    List<List<byte[]>> files = copy();
    List<byte[]> last = files.get(files.size() - 1);
    last.remove(last.size() - 1);
    restore(files);
    assertThat(AuditVerifier.verify(folder, List.of()).get(0).broken()).isEmpty();
    assertThat(verify().get(0).sentence())
        .contains("robot atrv1 of field signed number " + head.head().number());
  }

  @Test
  void aForgedHeadIsRefused() throws Exception {
    restore(FILES);
    AuditHead real = head.head();
    AuditHead forged =
        new AuditHead(real.stream(), real.number() + 1, real.hash(), real.time(), real.signature());
    assertThatThrownBy(
            () -> AuditVerifier.verify(folder, List.of(KeptHead.of(forged, robot.certificate()))))
        .isInstanceOf(IOException.class)
        .hasMessageContaining("is not signed by the key");
  }
}
