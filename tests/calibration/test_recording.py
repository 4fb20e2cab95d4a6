"""Sound files: read as they are, and refused with one clear message."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from sweetspot.calibration.recording import BAT_BAND, FrequencyBand, Recording, in_band, read_recording, recording_bytes
from sweetspot.errors import InputError


def tone(frequency: float, rate: float, seconds: float = 0.5) -> Recording:
    return Recording("tone", 0.5 * np.sin(2 * np.pi * frequency * np.arange(round(seconds * rate)) / rate), rate)


@pytest.mark.parametrize("ending", ["wav", "flac", "aiff"])
def test_what_is_written_is_read_again(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"tone.{ending}"
    path.write_bytes(recording_bytes(tone(440, 44100), path))
    sound = read_recording(path)
    assert (sound.name, sound.rate, sound.duration) == (f"tone.{ending}", 44100, 0.5)
    np.testing.assert_allclose(sound.samples, tone(440, 44100).samples, atol=2**-23)


def test_of_several_channels_the_loudest(tmp_path: Path) -> None:
    import soundfile

    loud = tone(300, 8000).samples
    soundfile.write(tmp_path / "stereo.wav", np.stack([0.1 * loud, loud], axis=1), 8000, subtype="FLOAT")
    np.testing.assert_allclose(read_recording(tmp_path / "stereo.wav").samples, loud, atol=1e-7)


@pytest.mark.parametrize(("ending", "coding"), [("m4a", "aac"), ("mp4", "alac"), ("webm", "libopus")])
def test_a_phone_s_recording_is_read(ending: str, coding: str, tmp_path: Path) -> None:
    """A tone after a quarter of a second, written as phones and browsers do: begin, frequency and level stay."""
    import av

    tapped = np.concatenate([np.zeros(12000), tone(440, 48000).samples])
    with av.open(str(tmp_path / f"tap.{ending}"), "w") as container:
        stream = container.add_stream(coding, rate=48000, layout="stereo")
        assert isinstance(stream, av.AudioStream)
        shape = av.AudioResampler(format=stream.format.name, layout="stereo", rate=48000, frame_size=stream.frame_size)
        frame = av.AudioFrame.from_ndarray(np.stack([0.1 * tapped, tapped]).astype(np.float32), "fltp", "stereo")
        frame.sample_rate, frame.pts = 48000, 0
        for part in (*shape.resample(frame), *shape.resample(None)):
            container.mux(stream.encode(part))
        container.mux(stream.encode(None))
    sound = read_recording(tmp_path / f"tap.{ending}")
    assert (sound.rate, sound.lossy) == (48000, coding != "alac")
    assert sound.duration == pytest.approx(0.75, abs=0.05)
    assert np.abs(sound.samples[:11000]).max() < 0.02
    np.testing.assert_allclose(sound.samples[13000:35000], tapped[13000:35000], atol=0.03)


def test_a_film_without_sound_is_refused(tmp_path: Path) -> None:
    import av

    with av.open(str(tmp_path / "film.mp4"), "w") as container:
        stream = container.add_stream("mpeg4", rate=25)
        assert isinstance(stream, av.VideoStream)
        stream.width = stream.height = 16
        container.mux(stream.encode(av.VideoFrame(16, 16, "yuv420p")))
        container.mux(stream.encode(None))
    with pytest.raises(InputError, match="holds no sound"):
        read_recording(tmp_path / "film.mp4")


@pytest.mark.parametrize("rate", [11025.0, 48000.0, 384000.0])
def test_the_band_passes_and_the_rest_does_not(rate: float) -> None:
    inside = in_band(tone(1000, rate), BAT_BAND)
    assert np.abs(inside.samples[inside.samples.size // 2 :]).max() == pytest.approx(0.5, rel=0.01)
    rumble = in_band(tone(10, rate), BAT_BAND)
    assert np.abs(rumble.samples[rumble.samples.size // 2 :]).max() < 0.02


def test_what_lies_above_the_band_does_not_fold_into_it() -> None:
    """At 12.8 kHz a tone of 8 kHz would fold to 4.8 kHz."""
    folded = in_band(tone(8000, 384000), BAT_BAND)
    assert np.abs(folded.samples[1000:-1000]).max() < 0.5e-3


def test_the_delay_of_the_filter_is_taken_back() -> None:
    click = Recording("click", np.zeros(96000), 384000)
    click.samples[48000] = 1.0
    thinned = in_band(click, BAT_BAND)
    assert np.argmax(np.abs(thinned.samples)) / thinned.rate == pytest.approx(0.125, abs=1 / thinned.rate)


def test_a_recording_that_was_broken_off_is_read_to_its_end(tmp_path: Path) -> None:
    """A recorder writes how long its WAV is when it ends: until then it says 0."""
    import soundfile

    samples = 0.1 * np.sin(np.arange(4000))
    path = tmp_path / "whole.wav"
    soundfile.write(path, samples, 44100, subtype="PCM_24")
    whole = path.read_bytes()
    data = whole.index(b"data")
    broken = tmp_path / "broken.wav"
    broken.write_bytes(whole[:4] + bytes(4) + whole[8 : data + 4] + bytes(4) + whole[data + 8 :])
    assert np.array_equal(read_recording(broken).samples, read_recording(path).samples)
    broken.write_bytes(whole[: data + 4] + bytes(4))
    with pytest.raises(InputError, match="holds no sound"):
        read_recording(broken)


def test_samples_that_are_no_numbers_are_counted(tmp_path: Path) -> None:
    import soundfile

    samples = 0.1 * np.sin(np.arange(4000))
    samples[[7, 9]] = np.nan, np.inf
    soundfile.write(tmp_path / "torn.wav", samples, 44100, subtype="FLOAT")
    with pytest.raises(InputError, match="has 2 of 4,000 samples that are no numbers"):
        read_recording(tmp_path / "torn.wav")


def test_a_file_is_read_by_what_it_holds_and_not_by_its_name(tmp_path: Path) -> None:
    """A phone's recording that somebody renamed, and GSM, in which libsndfile cannot seek."""
    import av
    import soundfile

    sound = 0.3 * np.sin(0.3 * np.arange(8000))
    soundfile.write(tmp_path / "gsm.wav", sound, 8000, subtype="GSM610")
    assert len(read_recording(tmp_path / "gsm.wav").samples) >= 8000
    with av.open(str(tmp_path / "phone.m4a"), "w") as container:
        stream = container.add_stream("alac", rate=44100, layout="mono")
        frame = av.AudioFrame.from_ndarray((2**15 * sound[None, :4096]).astype(np.int16), format="s16p", layout="mono")
        frame.rate = 44100
        container.mux([*stream.encode(frame), *stream.encode(None)])
    renamed = read_recording((tmp_path / "phone.m4a").rename(tmp_path / "phone.wav"))
    assert renamed.samples == pytest.approx(sound[:4096], abs=1e-4)
    assert not renamed.lossy


def test_bad_files_are_refused(tmp_path: Path) -> None:
    import soundfile

    with pytest.raises(InputError, match="there is no such file"):
        read_recording(tmp_path / "none.wav")
    text = tmp_path / "text.wav"
    text.write_text("no sound", encoding="utf-8")
    with pytest.raises(InputError, match="cannot be read as a sound"):
        read_recording(text)
    phone = text.rename(tmp_path / "tap.m4a")
    with pytest.raises(InputError, match=r"cannot be read as a sound: .*; record anew, or convert it to WAV"):
        read_recording(phone)
    for name, samples, rate, message in (
        ("silent.wav", np.zeros(8000), 8000, "silent"),
        ("empty.wav", np.zeros(0), 8000, "no sound"),
        ("slow.wav", np.ones(100), 1000, "samples per second"),
        ("long.wav", np.ones(1_200_100), 2000, "lasts longer than 600 s, the most that is allowed. Cut out the taps"),
    ):
        soundfile.write(tmp_path / name, samples, rate)
        with pytest.raises(InputError, match=message):
            read_recording(tmp_path / name)
    with pytest.raises(InputError, match="louder than a sound file"):
        recording_bytes(Recording("loud", np.array([1.5]), 8000), tmp_path / "loud.wav")
    with pytest.raises(InputError, match=r"nothing above 3600 Hz; the band begins at 4000 Hz"):
        in_band(tone(100, 8000), FrequencyBand(4000.0, 9000.0))
    with pytest.raises(InputError, match="0 < low < high"):
        FrequencyBand(500.0, 100.0)
