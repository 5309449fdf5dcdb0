package org.dfra.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import org.dfra.cli.doctor.Subject;
import org.junit.jupiter.api.Test;

/** What {@code ./dfra doctor} may find is explained. */
class FindingsTest {

  @Test
  void eachSubjectHasItsSectionAndThereIsNoOther() {
    String text = Documents.of("docs/troubleshooting.md").text();
    String doctor = text.substring(text.indexOf("\n## What `./dfra doctor` finds\n"));
    List<String> sections =
        doctor
            .lines()
            .filter(line -> line.matches("### `[a-z-]+`"))
            .map(line -> line.substring(5, line.length() - 1))
            .toList();
    assertThat(sections)
        .containsExactlyElementsOf(Arrays.stream(Subject.values()).map(Subject::id).toList());
  }
}
