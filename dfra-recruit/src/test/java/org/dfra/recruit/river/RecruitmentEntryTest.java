package org.dfra.recruit.river;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import net.jini.core.entry.Entry;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.river.entry.Entries;
import org.junit.jupiter.api.Test;

/** The entry that this jar brings along is made of its record, and gives it back. */
class RecruitmentEntryTest {

  @Test
  void mirrorsItsRecord() {
    RecruitmentAttributes attributes =
        new RecruitmentAttributes(List.of("mine", "heat"), 0.7, "affective", 20, 1);
    Entry[] entries = Entries.toEntries(List.of(attributes));
    assertThat(entries).hasSize(1);
    assertThat(entries[0])
        .isInstanceOfSatisfying(
            RecruitmentEntry.class,
            entry -> {
              assertThat(entry.percepts).containsExactly("heat", "mine");
              assertThat(entry.speed).isEqualTo(0.7);
              assertThat(entry.strategy).isEqualTo("affective", 20, 1);
            });
    assertThat(Entries.toAttributes(entries)).containsExactly(attributes);
  }

  @Test
  void whatOneThatIsHeldSaysComesBack() {
    RecruitmentAttributes attributes =
        new RecruitmentAttributes(
            List.of("mine"), 0.7, "affective", 20, 1, "an operator stopped it");
    assertThat(Entries.toAttributes(Entries.toEntries(List.of(attributes))))
        .containsExactly(attributes);
  }

  @Test
  void thatLacksWhatItsRecordMustHaveIsLeftOut() {
    RecruitmentEntry half = new RecruitmentEntry();
    half.percepts = List.of("mine");
    assertThat(Entries.toAttributes(new Entry[] {half})).isEmpty();
  }
}
