package org.dfra.core.audit;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.dfra.core.host.PrivateFiles;
import org.dfra.core.state.StateStore;
import org.jspecify.annotations.Nullable;

/**
 * The heads that a member keeps of others, in a file: for each stream the newest one, and earlier
 * ones that are at least {@link #ANCHOR_INTERVAL} apart by the keeper's clock. Somebody who has
 * taken over a robot can sign new heads of a trail that was written again, but cannot make others
 * forget the earlier ones. Thread-safe; of several stores of one file, only one may be used at a
 * time.
 *
 * <p>How heads travel between members is not its concern: a transport calls {@link #keep} with what
 * it received, after it has checked that the certificate is of this team.
 */
public final class HeadStore {

  /** Most streams of one member. */
  public static final int MOST_STREAMS = 64;

  /** Most streams of all members. */
  public static final int MOST_HEADS = 512;

  /** Most heads of one stream, the newest included. */
  public static final int MOST_OF_STREAM = 9;

  /** At least this long is between two heads that stay, by the keeper's clock. */
  public static final Duration ANCHOR_INTERVAL = Duration.ofHours(3);

  /** What became of a head. */
  public enum Outcome {
    /** It is kept. */
    KEPT,
    /** A head with the same or a higher number is kept already. */
    KNOWN,
    /**
     * A kept head has the same number and another hash. Both are signed: this proves that the trail
     * was rewritten. The kept head stays, and the first that contradicts is kept beside it.
     */
    CONTRADICTION,
    /** The certificate's key has not signed it. */
    NOT_SIGNED,
    /** There are too many streams already. */
    FULL
  }

  /** The member's text first: it names the owner of a trail. */
  private record Key(String member, String stream) implements Comparable<Key> {
    @Override
    public int compareTo(Key other) {
      int byMember = member.compareTo(other.member);
      return byMember != 0 ? byMember : stream.compareTo(other.stream);
    }
  }

  private final Path file;
  private final StateStore disk;
  private final InstantSource clock;

  @GuardedBy("this")
  private final Map<Key, StreamHeads> heads = new TreeMap<>();

  private HeadStore(Path file, StateStore disk, InstantSource clock) {
    this.file = file;
    this.disk = disk;
    this.clock = clock;
  }

  /**
   * Opens a store.
   *
   * @param file the heads; created if missing, in a folder that becomes private
   * @param clock of the keeper
   * @throws IOException if the folder is not private, or the file is no store of heads
   */
  public static HeadStore open(Path file, InstantSource clock) throws IOException {
    Path absolute = file.toAbsolutePath();
    @Nullable Path folder = absolute.getParent();
    if (folder == null) {
      throw new IOException(file + " is a folder; name a file for the heads of audit trails");
    }
    PrivateFiles.requireFolder(folder);
    PrivateFiles.makeFile(absolute);
    HeadStore store = new HeadStore(absolute, StateStore.inFolder(folder), clock);
    store.load(HeadCodec.read(absolute));
    return store;
  }

  private synchronized void load(List<ReceivedHead> all) {
    for (ReceivedHead each : all) {
      Key key = key(each.kept());
      heads.put(key, heads.getOrDefault(key, StreamHeads.NONE).loaded(each));
    }
  }

  private static Key key(KeptHead head) {
    return new Key(head.member().toString(), head.head().stream());
  }

  /**
   * Keeps a head if it is newer.
   *
   * @param certificate of the member that signed it, which the caller has checked
   * @throws IOException if it cannot be written; then the former heads stay
   * @throws IllegalArgumentException if the certificate names no member
   */
  public Outcome keep(AuditHead head, X509Certificate certificate) throws IOException {
    return keep(List.of(head), certificate).get(0);
  }

  /**
   * Keeps those heads of a member that are newer, and writes the file once.
   *
   * @param certificate of the member that signed them, which the caller has checked
   * @return what became of each
   * @throws IOException if they cannot be written; then the former heads stay
   * @throws IllegalArgumentException if the certificate names no member
   */
  public synchronized List<Outcome> keep(List<AuditHead> offered, X509Certificate certificate)
      throws IOException {
    Map<Key, StreamHeads> all = new TreeMap<>(heads);
    Instant now = clock.instant();
    List<Outcome> outcomes = new ArrayList<>();
    for (AuditHead each : offered) {
      outcomes.add(add(new ReceivedHead(KeptHead.of(each, certificate), now), all));
    }
    if (!all.equals(heads)) {
      write(all);
      heads.putAll(all);
    }
    return outcomes;
  }

  private static Outcome add(ReceivedHead fresh, Map<Key, StreamHeads> all) {
    if (!fresh.kept().isSigned()) {
      return Outcome.NOT_SIGNED;
    }
    Key key = key(fresh.kept());
    @Nullable StreamHeads known = all.get(key);
    if (known == null && isFull(key.member(), all)) {
      return Outcome.FULL;
    }
    StreamHeads before = known == null ? StreamHeads.NONE : known;
    all.put(key, before.with(fresh));
    return before.outcome(fresh.kept());
  }

  private static boolean isFull(String member, Map<Key, StreamHeads> all) {
    long own = all.keySet().stream().filter(each -> each.member().equals(member)).count();
    return own >= MOST_STREAMS || all.size() >= MOST_HEADS;
  }

  private void write(Map<Key, StreamHeads> all) throws IOException {
    String lines =
        all.values().stream()
            .flatMap(each -> each.all().stream())
            .map(each -> HeadCodec.line(each) + "\n")
            .collect(Collectors.joining());
    disk.write(String.valueOf(file.getFileName()), lines.getBytes(StandardCharsets.UTF_8));
    PrivateFiles.closeToOthers(file);
  }

  /** All heads, ordered by member, stream and number. */
  public synchronized List<KeptHead> heads() {
    return heads.values().stream()
        .flatMap(each -> each.all().stream())
        .map(ReceivedHead::kept)
        .toList();
  }

  /** When the newest head of a member was received; empty if none was. */
  public synchronized Optional<Instant> lastReceived(String member) {
    return heads.entrySet().stream()
        .filter(each -> each.getKey().member().equals(member))
        .map(each -> each.getValue().newest().received())
        .max(Comparator.naturalOrder());
  }

  /**
   * Reads the heads of a store, also of one that another process uses.
   *
   * @return in the order of the lines
   * @throws IOException if it cannot be read, or is no store of heads; the message names the line
   */
  public static List<KeptHead> read(Path file) throws IOException {
    return HeadCodec.read(file).stream().map(ReceivedHead::kept).toList();
  }

  /**
   * The text of heads, as a store has them.
   *
   * @param heads of one member
   */
  public static byte[] text(List<KeptHead> heads) {
    return heads.stream()
        .map(each -> HeadCodec.line(new ReceivedHead(each, each.head().time())) + "\n")
        .collect(Collectors.joining())
        .getBytes(StandardCharsets.UTF_8);
  }

  /**
   * The opposite of {@link #text}.
   *
   * @param name of the source, for messages
   * @throws IOException if these are no heads, or too many
   */
  public static List<KeptHead> parse(byte[] text, String name) throws IOException {
    return HeadCodec.read(new ByteArrayInputStream(text), name).stream()
        .map(ReceivedHead::kept)
        .toList();
  }
}
