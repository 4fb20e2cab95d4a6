"""Sound files of taps: read, made mono, reduced to the band in which bats ring."""

from __future__ import annotations

import errno
import io
import math
import struct
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from sweetspot.dynamics.modes import Modes, tapped
from sweetspot.errors import InputError
from sweetspot.numerics.arrays import Array
from sweetspot.numerics.text_files import check_ordinary

Channels = Array | NDArray[np.float32]
"""Samples of all channels, shape (samples, channels)."""
LONGEST = 600.0
"""s of a recording at most."""
MOST_SAMPLES = 120_000_000
"""Of all channels: ten minutes of two at 96 kHz."""
MOST_CHANNELS = 64
"""Of the largest recorders of studios; one is used."""
LARGEST = 500_000_000
"""Bytes of a file."""
SLOWEST_RATE = 2000.0
"""Hz; below, even the first mode of a bat is lost."""
FASTEST_RATE = 1e6
"""Hz, more than sound cards and most analyzers of vibration have (assumed)."""
OVERSAMPLING = 2.56
"""Samples kept per period of the band's upper end."""
SOUND_FILES = (".wav", ".flac", ".ogg", ".mp3", ".aiff")
"""Endings of recordings that soundfile reads."""
OF_PHONES = (".m4a", ".aac", ".mp4", ".mov", ".3gp", ".amr", ".wma", ".webm")
"""Endings of those that it has no decoder for."""
CONTAINERS = "mov,aac,amr,asf,matroska,mp3,wav,flac,ogg,aiff,caf,w64,au,ac3,avi"
"""Formats by FFmpeg's names that it may open: each is one file with its sound; lists name other files."""
UNKNOWN_FORMAT = 1
"""The error of libsndfile about a format that it does not know."""
LOSSLESS = ("alac", "flac", "pcm")
"""Beginnings of the names of codings of phones that leave out nothing."""
AT_REST = 0.05
"""s whose mean a recording began with: an offset of the microphone is no blow."""
LOSSY = ("VORBIS", "OPUS", "MPEG", "GSM", "NMS_ADPCM", "G72")
"""Beginnings of the names of codings that leave out what is hard to hear."""
STOPPED = 80.0
"""dB by which the filter before thinning out lowers what would fold back."""


@dataclass(frozen=True)
class FrequencyBand:
    """The frequencies looked at, Hz, 0 < ``low`` < ``high``."""

    low: float
    high: float

    def __post_init__(self) -> None:
        if not 0 < self.low < self.high < math.inf:
            raise InputError(f"the band runs from {self.low:g} to {self.high:g} Hz; allowed is 0 < low < high")


BAT_BAND = FrequencyBand(60.0, 5000.0)
"""Bending modes of bats begin above 100 Hz, hoop modes end below 5 kHz; below 60 Hz there are steps and mains hum."""


@dataclass(frozen=True)
class Recording:
    """A sound with one channel.

    ``samples``: full scale is -1 to 1. ``rate``: samples per s. ``lossy``: whether its format leaves out what is hard
    to hear.
    """

    name: str
    samples: Array
    rate: float
    lossy: bool = False

    @property
    def duration(self) -> float:
        """Length in s."""
        return len(self.samples) / self.rate


def read_recording(path: Path, *, most: int = MOST_SAMPLES) -> Recording:
    """Return a sound file (WAV, FLAC, OGG, MP3, AIFF, a phone's M4A, AAC, 3GP, a browser's WebM).

    Of several channels it is the loudest.
    """
    check_ordinary(path, most=LARGEST, advice="record WAV, FLAC, OGG, MP3 or M4A, and cut out the taps")
    channels, rate, lossy = (_of_phone if path.suffix.lower() in OF_PHONES else _of_sound_file)(path, most)
    if not channels.size:
        raise InputError(f"{path} holds no sound; record at least one tap")
    if wrong := int((~np.isfinite(channels)).any(axis=1).sum()):
        raise InputError(f"{path} has {wrong:,} of {len(channels):,} samples that are no numbers; export it anew")
    loudest = max(channels.T, key=np.var) if channels.shape[1] > 1 else channels[:, 0]
    samples = np.array(loudest, np.float64)  # its own, so that the others are let go
    if not np.ptp(samples):
        raise InputError(f"{path} is silent; check the microphone")
    return Recording(path.name, samples, rate, lossy)


def _of_sound_file(path: Path, most: int) -> tuple[Channels, float, bool]:
    """Return the samples, shape (samples, channels), their rate, and whether the coding loses something."""
    import soundfile

    try:
        with soundfile.SoundFile(_mended(path)) as sound:
            _check_header(path, sound.frames, rate=sound.samplerate, channels=sound.channels, most=most)
            channels = sound.read(sound.frames, dtype="float64", always_2d=True)  # GSM cannot be sought in
            return channels, float(sound.samplerate), sound.subtype.startswith(LOSSY)
    except (soundfile.SoundFileError, OSError, RuntimeError) as error:
        if getattr(error, "code", None) == UNKNOWN_FORMAT:  # a phone's file under another name
            return _of_phone(path, most)
        reason = str(error).rpartition(": ")[2].rstrip(".")
        raise InputError(f"{path} cannot be read as a sound: {reason}; record WAV, FLAC, OGG, MP3 or M4A") from None


def _mended(path: Path) -> Path | io.BytesIO:
    """Return a file; where a recorder was stopped before it wrote how long its WAV is, the file with that length."""
    with path.open("rb") as file:
        form, _, kind = struct.unpack("<4sI4s", (file.read(12) + bytes(12))[:12])
        if (form, kind) != (b"RIFF", b"WAVE"):
            return path
        while len(head := file.read(8)) == 8:
            name, size = struct.unpack("<4sI", head)
            if name == b"data":
                begin, end = file.tell(), file.seek(0, io.SEEK_END)
                if size or end == begin:
                    return path
                file.seek(0)
                whole = bytearray(file.read())
                struct.pack_into("<I", whole, 4, end - 8)
                struct.pack_into("<I", whole, begin - 4, end - begin)
                return io.BytesIO(whole)
            file.seek(size + size % 2, io.SEEK_CUR)
    return path


def _of_phone(path: Path, most: int) -> tuple[Channels, float, bool]:
    """Return the same of a file as phones write them; it has 32 bits at most."""
    import av

    try:
        with av.open(str(path), options={"format_whitelist": CONTAINERS}) as container:
            if not container.streams.audio:
                raise InputError(f"{path} holds no sound; record at least one tap")
            stream = container.streams.audio[0]
            floats = av.AudioResampler(format="fltp")  # the same samples, one row a channel
            blocks: list[NDArray[np.float32]] = []
            heard, rate = 0, stream.rate or 0
            _check_header(path, heard, rate=rate, channels=stream.channels, most=most)
            for frame in container.decode(stream):
                for block in floats.resample(frame):
                    blocks.append(np.asarray(block.to_ndarray(), np.float32))
                    heard += blocks[-1].shape[1]
                    _check_header(path, heard, rate=rate, channels=len(blocks[-1]), most=most)
            channels = np.concatenate(blocks, axis=1).T if blocks else np.empty((0, 1))
            return channels, float(rate), not stream.codec_context.name.startswith(LOSSLESS)
    except InputError:
        raise
    except (av.FFmpegError, OSError, ValueError) as error:
        reason = (
            "unknown format"
            if getattr(error, "errno", None) == errno.EINVAL
            else getattr(error, "strerror", None) or error
        )
        raise InputError(
            f"{path} cannot be read as a sound: {reason}; record anew, or convert it to WAV, FLAC, OGG or MP3"
        ) from None


def _check_header(path: Path, frames: int, *, rate: int, channels: int, most: int) -> None:
    """Refuse what a header says, before memory is taken for it, and what is more than it said while it is read."""
    if not SLOWEST_RATE <= rate <= FASTEST_RATE:
        raise InputError(
            f"{path} has {rate} samples per second; allowed is {SLOWEST_RATE:.0f} to {FASTEST_RATE:.0f}. Export it anew"
        )
    if channels > MOST_CHANNELS:
        raise InputError(f"{path} has {channels} channels; allowed are {MOST_CHANNELS}. Keep one of them")
    if frames > LONGEST * rate:
        raise InputError(f"{path} lasts longer than {LONGEST:g} s, the most that is allowed. Cut out the taps")
    if frames * channels > most:
        raise InputError(
            f"{path} has {frames} samples or more in each of its channels ({channels}); all together may have {most}. "
            "Keep one channel, and cut out the taps"
        )


def in_band(recording: Recording, band: FrequencyBand) -> Recording:
    """Return the recording without what lies below and above the band, at no more samples than it needs.

    The high-pass is causal, so that nothing of a tap comes before it.
    """
    import scipy.signal

    high = min(band.high, 0.45 * recording.rate)
    if band.low >= high:
        raise InputError(
            f"{recording.name} has {recording.rate:g} samples per second and nothing above {high:.0f} Hz; "
            f"the band begins at {band.low:g} Hz"
        )
    factor = max(1, int(recording.rate / (OVERSAMPLING * high)))
    before = recording.samples[: round(AT_REST * recording.rate)].mean()  # where it had been until the recording began
    samples, rate = recording.samples - before, recording.rate / factor
    if factor > 1:  # what folds back lands above the band
        taps, shape = scipy.signal.kaiserord(STOPPED, 2 * (rate - 2 * high) / recording.rate)
        lowpass = scipy.signal.firwin(taps | 1, rate / 2, window=("kaiser", shape), fs=recording.rate)
        held = np.pad(samples, (0, len(lowpass) // 2), mode="edge")  # it does not break off at its end
        thin = scipy.signal.upfirdn(lowpass, held, 1, factor)[taps // 2 // factor :]
        samples = np.asarray(thin[: -(-len(samples) // factor)])
    highpass = scipy.signal.butter(2, band.low, "highpass", fs=rate, output="sos")
    return Recording(recording.name, np.asarray(scipy.signal.sosfilt(highpass, samples)), rate)


def recording_bytes(recording: Recording, path: Path) -> bytes:
    """Return a recording as a sound file of 24 bit, by its name's ending; louder than full scale is refused."""
    import soundfile

    if np.abs(recording.samples).max(initial=0.0) >= 1:
        raise InputError(f"{recording.name} is louder than a sound file can hold; make it quieter")
    held = io.BytesIO()
    try:
        ending = path.suffix[1:]
        soundfile.write(held, recording.samples, round(recording.rate), subtype="PCM_24", format=ending or "none")
        return held.getvalue()
    except (soundfile.SoundFileError, OSError, RuntimeError, TypeError, ValueError) as error:
        raise InputError(f"{path} cannot be written as a sound: {error}; write to a name that ends in .wav") from None


RATE = 44100.0
"""Samples per s."""
SOFT_TAP = 0.0004
"""s, contact of a small hard hammer with wood (assumed)."""
LOUDNESS = 0.5
"""Of full scale, the loudest sample of the loudest tap."""


def tap_sound(
    modes: Modes,
    *,
    position: float,
    listened: float,
    duration: float = SOFT_TAP,
    seconds: float = 1.0,
    rate: float = RATE,
) -> Array:
    """Return the sound of one tap from its beginning on, in any unit, shape (n,).

    ``position``, ``listened``: m from the knob end, where it is tapped and where the microphone is. ``duration``: of
    the contact, s. ``seconds``, ``rate``: length of the sound and samples per s.
    """
    ringing = [index for index, family in enumerate(modes.families) if family != "rigid"]
    time = np.arange(round(seconds * rate)) / rate
    natural, ratio = modes.angular_frequency[ringing], modes.damping_ratio[ringing]
    speed = tapped(modes, position=position, duration=duration)[ringing]
    loud = speed * modes.shape_at(listened)[ringing] * natural
    heard = 2 * np.pi * 0.45 * rate > natural
    sound = np.zeros_like(time)
    for amplitude, omega, zeta in zip(loud[heard], natural[heard], ratio[heard], strict=True):
        sound += amplitude * np.exp(-zeta * omega * time) * np.sin(omega * np.sqrt(1 - zeta**2) * time)
    return sound


def synthesised(
    modes: Modes,
    *,
    position: float,
    listened: float,
    taps: int = 3,
    apart: float = 1.0,
    noise: float = 0.002,
    seed: int = 1,
) -> Recording:
    """Return a recording of several taps of different strength in white noise.

    ``position``, ``listened``: m from the knob end, where it is tapped and where the microphone is. ``apart``: s from
    tap to tap. ``noise``: rms over the loudest sample.
    """
    generator = np.random.default_rng(seed)
    tap = tap_sound(modes, position=position, listened=listened, seconds=apart)
    tap = LOUDNESS * tap / np.abs(tap).max()
    strength = generator.uniform(0.6, 1.0, taps)
    quiet = np.zeros(round(0.3 * RATE))
    sound = np.concatenate([quiet, *(part * tap for part in strength)])
    return Recording("synthetic", sound + noise * LOUDNESS * generator.standard_normal(len(sound)), RATE)
