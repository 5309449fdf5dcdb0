package org.dfra.examples.mission;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dfra.examples.mission.MissionProgressListener.MissionEvent;

/** Records the events of a search by one robot. */
public final class RecordingMissionListener implements MissionProgressListener {

  private final List<MissionEvent> marks = new ArrayList<>();

  @Override
  public void onProgress(List<RobotProgress> robots) {
    assertThat(robots).hasSize(1);
  }

  @Override
  public void onEvent(MissionEvent mark) {
    marks.add(mark);
  }

  /** All that has happened, in the order in which it was reported. */
  public List<MissionEvent> marks() {
    return List.copyOf(marks);
  }
}
